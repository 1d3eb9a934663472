#include "fourwis_navigation/model/fingerprint.h"

#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{

std::string Fingerprint::text() const
{
  return sentence("%016llx", static_cast<unsigned long long>(hash_));
}

void Fingerprint::add(std::string_view key, std::string_view value)
{
  constexpr std::uint64_t kPrime = 0x100000001b3;
  const auto take = [this](char byte) { hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * kPrime; };
  for (const char byte : key) take(byte);
  take('=');
  for (const char byte : value) take(byte);
  take('\n');
}

}  // namespace fourwis
