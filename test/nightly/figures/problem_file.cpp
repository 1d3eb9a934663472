#include "problem_file.h"

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "fourwis_navigation/map/map_file.h"
#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis::nightly
{
namespace
{

std::vector<std::string> split(const std::string& line, char separator)
{
  std::vector<std::string> words;
  std::istringstream in(line);
  for (std::string word; std::getline(in, word, separator);) words.push_back(word);
  return words;
}

Pose pose_in(const std::string& text)
{
  Pose pose;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf", &pose.x, &pose.y, &pose.theta) != 3)
    throw std::runtime_error("not a pose x,y,yaw: " + text);
  return pose;
}

ModeSet modes_in(const std::string& text)
{
  if (text.empty()) return ModeSet();
  ModeSet modes = ModeSet::none();
  for (const std::string& name : split(text, ','))
  {
    const auto mode = mode_from_string(name);
    if (!mode) throw std::runtime_error("not a mode: " + name);
    modes.insert(*mode);
  }
  return modes;
}

}  // namespace

std::vector<FileCase> read_cases(const std::string& path)
{
  std::ifstream in(path);
  const std::string folder = path.substr(0, path.rfind('/') + 1);
  std::vector<FileCase> cases;
  std::string line;
  std::getline(in, line);  // the header
  for (int number = 2; std::getline(in, line); ++number)
  {
    const std::vector<std::string> words = split(line, ';');
    if (words.size() < 6) throw std::runtime_error(path + ":" + std::to_string(number) + ": expected six columns");
    cases.push_back({words[0], read_map_file(folder + words[1]),
                     words[4].empty() ? Robot() : read_robot_file(folder + words[4]), pose_in(words[2]),
                     pose_in(words[3]), modes_in(words[5])});
  }
  return cases;
}

}  // namespace fourwis::nightly
