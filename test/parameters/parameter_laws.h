#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "complaint.h"
#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis
{

/// The least and the greatest number that a key may be, written down here once more: the code's own table is what is tested.
struct Limits
{
  double least = NAN, greatest = NAN;  ///< none for what is no number
  bool whole = false;                  ///< whether fractions are refused
};

constexpr bool kWhole = true;

/// A key, the member that it must set, as a number, and what it may be.
template <class Options>
struct Binding
{
  std::string key;
  std::function<double(const Options&)> get;
  Limits limits = {};
};

inline ParameterMap with(ParameterMap parameters, const std::string& key, const ParameterValue& value)
{
  parameters[key] = value;
  return parameters;
}

/// A configuration file, what reads it, and where its keys go.
template <class Options>
struct Subject
{
  std::string file;
  Options (*read)(const ParameterMap&);
  std::vector<Binding<Options>> bindings;
  /// The parameters with a key changed, and others that would contradict it.
  ParameterMap (*with_fitting)(ParameterMap, const std::string&, const ParameterValue&) = with;
  ParameterMap open = {};  ///< keys that the shipped file leaves open, with a value that they may have

  /// A value for each key.
  ParameterMap values() const
  {
    ParameterMap all = read_parameter_file(file);
    all.insert(open.begin(), open.end());
    return all;
  }
};

/// Any word, but of a key that knows few words another one of these.
inline std::string another_word(const std::string& word)
{
  static const std::map<std::string, std::string> known = {
      {"cia402", "ranger"},
      {"cyclic", "profile"},
      {"structured", "ipopt"},
      {"default", "paper"},
      {"tf", "initialpose"},
      {"[0, 0]", "[0.05, 0.02]"},
      {"[]", "[[0.5, 0.4], [-0.5, 0.4], [-0.5, -0.4], [0.5, -0.4]]"},
      {"ackermann,lateral,parallel", "lateral"}};
  const auto found = known.find(word);
  return found == known.end() ? word + "x" : found->second;
}

/// A value the key does not have in the shipped file but could.
inline ParameterValue another(const ParameterValue& value, bool whole)
{
  if (const bool* flag = std::get_if<bool>(&value)) return !*flag;
  if (const std::string* word = std::get_if<std::string>(&value)) return another_word(*word);
  const double number = std::get<double>(value);
  if (number == 0.0) return whole ? 1.0 : 0.05;
  if (number == 1.0) return 2.0;
  return number > 1.0 && number == std::floor(number) ? number - 1.0 : number * 0.999;
}

/// The file that sets Options; each test of a file specialises it.
template <class Options>
Subject<Options> subject_of();

/// What every configuration file promises.
template <class Options>
class ParameterLaws : public testing::Test
{};
TYPED_TEST_SUITE_P(ParameterLaws);

TYPED_TEST_P(ParameterLaws, ShippedFileHoldsEveryKeyAndEqualsTheDefaults)
{
  const auto subject = subject_of<TypeParam>();
  const ParameterMap parameters = read_parameter_file(subject.file);
  EXPECT_EQ(parameters.size() + subject.open.size(), subject.bindings.size());
  const TypeParam shipped = subject.read(parameters), defaults;
  for (const Binding<TypeParam>& binding : subject.bindings)
  {
    EXPECT_EQ(parameters.count(binding.key) + subject.open.count(binding.key), 1u) << binding.key;
    EXPECT_EQ(binding.get(shipped), binding.get(defaults)) << binding.key;
  }
}

TYPED_TEST_P(ParameterLaws, EachKeySetsItsOwnMemberAndNoOther)
{
  const auto subject = subject_of<TypeParam>();
  const ParameterMap shipped = read_parameter_file(subject.file);
  for (const Binding<TypeParam>& changed : subject.bindings)
  {
    const ParameterValue value = another(subject.values().at(changed.key), changed.limits.whole);
    const TypeParam options = subject.read(with(shipped, changed.key, value));
    const TypeParam defaults;
    for (const Binding<TypeParam>& binding : subject.bindings)
      EXPECT_EQ(binding.get(options) != binding.get(defaults), binding.key == changed.key)
          << changed.key << " changed, looking at " << binding.key;
  }
}

TYPED_TEST_P(ParameterLaws, EachMissingKeyTakesItsDefault)
{
  const auto subject = subject_of<TypeParam>();
  const ParameterMap shipped = read_parameter_file(subject.file);
  for (const auto& [key, value] : shipped)
  {
    ParameterMap parameters = shipped;
    parameters.erase(key);
    const TypeParam options = subject.read(parameters), defaults;
    for (const Binding<TypeParam>& binding : subject.bindings)
      EXPECT_EQ(binding.get(options), binding.get(defaults)) << key << " left out, looking at " << binding.key;
  }
}

TYPED_TEST_P(ParameterLaws, UnknownKeyIsRejectedByNameAndTheKnownOnesAreListed)
{
  const auto subject = subject_of<TypeParam>();
  const ParameterMap shipped = read_parameter_file(subject.file);
  for (const std::string key : {"wheel_base", "", "search/step_time"})
  {
    const std::string text = complaint(subject.read, with(shipped, key, 0.25));
    EXPECT_TRUE(contains(text, "'" + key + "'")) << text;
    EXPECT_TRUE(contains(text, "0.25")) << text;
    for (const auto& [known, value] : shipped) EXPECT_TRUE(contains(text, known)) << text;
  }
}

/// "1e+12", as in the texts.
inline std::string shown(double number)
{
  std::ostringstream text;
  text.precision(10);
  text << number;
  return text.str();
}

TYPED_TEST_P(ParameterLaws, EveryNumberHasItsLimitsInTheTest)
{
  const auto subject = subject_of<TypeParam>();
  const ParameterMap shipped = read_parameter_file(subject.file);
  for (const auto& [key, get, limits] : subject.bindings)
    EXPECT_EQ(std::holds_alternative<double>(subject.values().at(key)), limits.least < limits.greatest) << key;
}

TYPED_TEST_P(ParameterLaws, NumberOutsideTheRangeIsRejectedByNameValueAndRange)
{
  const auto subject = subject_of<TypeParam>();
  const double inf = std::numeric_limits<double>::infinity();
  const ParameterMap shipped = read_parameter_file(subject.file);
  for (const auto& [key, get, limits] : subject.bindings)
  {
    if (!std::holds_alternative<double>(subject.values().at(key))) continue;
    double min = NAN, max = NAN;
    for (const double bad : {-1e12, 1e12, inf, -inf, std::nan("")})
    {
      const std::string text = complaint(subject.read, with(shipped, key, bad));
      EXPECT_TRUE(contains(text, "'" + key + "' is " + shown(bad) + ", expected a")) << text;
      ASSERT_TRUE(contains(text, " from ")) << text;
      ASSERT_EQ(std::sscanf(text.c_str() + text.find(" from "), " from %lf to %lf", &min, &max), 2) << text;
      EXPECT_EQ(min, limits.least) << text;
      EXPECT_EQ(max, limits.greatest) << text;
    }
  }
}

TYPED_TEST_P(ParameterLaws, LimitsAreAllowedAndTheNextNumbersBeyondAreNot)
{
  const auto subject = subject_of<TypeParam>();
  const double inf = std::numeric_limits<double>::infinity();
  const ParameterMap shipped = read_parameter_file(subject.file);
  const auto said = [&](const std::string& key, double value) {
    return complaint(subject.read, subject.with_fitting(shipped, key, value));
  };
  for (const auto& [key, get, limits] : subject.bindings)
  {
    if (!std::holds_alternative<double>(subject.values().at(key))) continue;
    EXPECT_EQ(said(key, limits.least), "") << key;
    EXPECT_EQ(said(key, limits.greatest), "") << key;
    for (const double beyond : {std::nextafter(limits.least, -inf), std::nextafter(limits.greatest, inf)})
      EXPECT_TRUE(contains(said(key, beyond), "'" + key + "' is ")) << key << " = " << beyond;
    if (!limits.whole) continue;
    for (const double bad : {limits.least - 1.0, limits.greatest + 1.0, limits.least + 0.5})
      EXPECT_TRUE(contains(said(key, bad), "'" + key + "' is " + shown(bad) + ", expected a whole number")) << key;
  }
}

TYPED_TEST_P(ParameterLaws, WrongTypeIsRejectedByNameAndValue)
{
  const auto subject = subject_of<TypeParam>();
  const ParameterMap shipped = read_parameter_file(subject.file);
  for (const auto& [key, value] : shipped)
  {
    if (std::holds_alternative<std::string>(value))
    {
      const std::string text = complaint(subject.read, with(shipped, key, 1.0));
      EXPECT_TRUE(contains(text, "'" + key + "' is 1, expected ")) << text;
      continue;
    }
    const bool flag = std::holds_alternative<bool>(value);
    const std::string swapped = complaint(subject.read, with(shipped, key, flag ? ParameterValue(1.0) : true));
    EXPECT_TRUE(contains(swapped, "'" + key + (flag ? "' is 1, expected true or false" : "' is true, expected a ")))
        << swapped;
    const std::string word = complaint(subject.read, with(shipped, key, std::string("fast")));
    EXPECT_TRUE(contains(word, "'" + key + "' is 'fast', expected ")) << word;
  }
}

REGISTER_TYPED_TEST_SUITE_P(ParameterLaws, ShippedFileHoldsEveryKeyAndEqualsTheDefaults,
                            EachKeySetsItsOwnMemberAndNoOther, EachMissingKeyTakesItsDefault,
                            UnknownKeyIsRejectedByNameAndTheKnownOnesAreListed, EveryNumberHasItsLimitsInTheTest,
                            NumberOutsideTheRangeIsRejectedByNameValueAndRange,
                            LimitsAreAllowedAndTheNextNumbersBeyondAreNot, WrongTypeIsRejectedByNameAndValue);

}  // namespace fourwis
