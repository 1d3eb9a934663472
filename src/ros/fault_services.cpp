#include "fault_services.h"

#include "conversions.h"

namespace fourwis
{

using fourwis_navigation::InjectFault;

FaultServices::FaultServices(Inject inject, std::function<void()> clear)
{
  inject_ = node_.advertiseService<InjectFault::Request, InjectFault::Response>(
      "inject_fault", [inject](InjectFault::Request& request, InjectFault::Response& response) {
        try
        {
          inject(request);
          response.success = true;
        }
        catch (const ConversionError& error)
        {
          response.message = error.what();
        }
        return true;
      });
  clear_ = node_.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>(
      "clear_faults", [clear](std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
        clear();
        response.success = true;
        return true;
      });
}

}  // namespace fourwis
