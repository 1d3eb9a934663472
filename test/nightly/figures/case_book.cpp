#include "case_book.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "../../support/random.h"
#include "fourwis_navigation/map/map_file.h"
#include "fourwis_navigation/model/option_check.h"

namespace fourwis::nightly
{
namespace
{

std::string number(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string spelled(const Pose& pose)
{
  return number(pose.x) + "," + number(pose.y) + "," + number(pose.theta);
}

/// A list of modes as `plan --modes` takes it; empty for all.
std::string spelled(const ModeSet& modes)
{
  if (modes == ModeSet()) return {};
  std::string names = text(modes);
  std::replace(names.begin(), names.end(), '+', ',');
  return names;
}

/// Writes the rows of a robot's table as YAML.
struct RobotFile
{
  std::ofstream out;

  template <class... Range>
  void operator()(const char* key, double value, const Range&...)
  {
    out << key << ": " << number(value) << '\n';
  }
  template <class Value, class Text>
  void operator()(const char* key, const Value& value, const Text& text)
  {
    out << key << ": " << text.write(value) << '\n';
  }
};

void write_robot(const Robot& robot, const std::string& path)
{
  RobotFile file{std::ofstream(path)};
  Robot::describe(robot, file);
}

}  // namespace

CaseBook::CaseBook(const std::string& folder) : folder_(folder)
{
  if (folder_.empty()) return;
  std::filesystem::create_directories(folder_);
  std::ofstream(folder_ + "/cases.csv") << "id;map;start;goal;robot;modes;said\n";
}

/// The name of the file, without ending, that holds the question's map. Questions about one map share it.
std::string CaseBook::map_of(const Question& question)
{
  const std::string stem = question.name.substr(0, question.name.find('#'));
  if (!std::filesystem::exists(folder_ + "/" + stem + ".yaml")) write_map_file(*question.grid, folder_ + "/" + stem);
  return stem;
}

void CaseBook::add(const std::string& why, const Question& question, const Answer& answer)
{
  std::string said = answer.status + ": " + answer.message;
  std::replace(said.begin(), said.end(), ';', ',');
  char cpu[40];
  std::snprintf(cpu, sizeof cpu, " (%.2f s CPU)", answer.cpu);
  if (!answer.violation.empty()) said += " BUT " + answer.violation;
  std::cout << "  " << why << ": " << described(question) << ": " << said << cpu << std::endl;
  if (folder_.empty()) return;
  std::string id = question.name;
  std::replace(id.begin(), id.end(), '#', '_');
  while (!ids_.insert(id).second) id += "_";
  const std::string map = map_of(question), robot = id + "_robot.yaml";
  write_robot(question.robot, folder_ + "/" + robot);
  std::ofstream(folder_ + "/cases.csv", std::ios::app)
      << id << ';' << map << ".yaml;" << spelled(question.start) << ';' << spelled(question.goal) << ';' << robot << ';'
      << spelled(question.modes) << ";" << why << ": " << said << cpu << '\n';
}

}  // namespace fourwis::nightly
