#pragma once

#include <functional>
#include <string>

#include <gtest/gtest.h>

namespace fourwis
{

/// What the Error that `action` throws says; empty when it throws none.
template <class Error>
std::string error_of(const std::function<void()>& action)
{
  try
  {
    action();
    return "";
  }
  catch (const Error& error)
  {
    return error.what();
  }
}

inline testing::AssertionResult says(const std::string& text, const std::string& part)
{
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "'" << text << "' does not say '" << part << "'";
}

}  // namespace fourwis
