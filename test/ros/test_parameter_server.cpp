#include "ros/parameter_server.h"

#include <string>

#include <gtest/gtest.h>

#include "../support/sentences.h"

namespace fourwis
{
namespace
{

TEST(ParameterServer, the_parameter_servers_structs_are_flattened_and_its_numbers_are_numbers)
{
  XmlRpc::XmlRpcValue value;
  value["flag"] = true;
  value["count"] = 3;
  value["nested"]["ratio"] = 0.5;
  value["nested"]["deeper"]["name"] = "x";
  const ParameterMap parameters = to_parameters(value);
  EXPECT_EQ(parameters.size(), 4u);
  EXPECT_EQ(std::get<bool>(parameters.at("flag")), true);
  EXPECT_EQ(std::get<double>(parameters.at("count")), 3.0);
  EXPECT_EQ(std::get<double>(parameters.at("nested/ratio")), 0.5);
  EXPECT_EQ(std::get<std::string>(parameters.at("nested/deeper/name")), "x");
  EXPECT_TRUE(to_parameters(XmlRpc::XmlRpcValue()).empty());
}

TEST(ParameterServer, a_list_is_the_text_that_a_file_has)
{
  XmlRpc::XmlRpcValue value;
  value["robot"]["footprint"][0][0] = 1;
  value["robot"]["footprint"][0][1] = 0.25;
  value["robot"]["footprint"][1][0] = "5e-1";
  value["robot"]["footprint"][1][1] = -3.0;
  EXPECT_EQ(std::get<std::string>(to_parameters(value).at("robot/footprint")), "[[1, 0.25], [5e-1, -3]]");
}

TEST(ParameterServer, a_list_that_holds_no_numbers_is_refused_by_name)
{
  XmlRpc::XmlRpcValue value;
  value["robot"]["length"][0] = true;
  EXPECT_TRUE(says(error_of<ConfigError>([&] { to_parameters(value); }), "'robot/length'"));
}

}  // namespace
}  // namespace fourwis
