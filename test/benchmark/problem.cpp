#include "problem.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <locale>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "fourwis_navigation/map/map_file.h"

namespace fourwis::benchmark
{
namespace
{

std::vector<std::string> split(const std::string& line, char separator)
{
  std::vector<std::string> words(1);
  for (const char c : line)
  {
    if (c == separator)
      words.emplace_back();
    else if (c != '\r')
      words.back() += c;
  }
  return words;
}

std::optional<double> number_in(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  if (!(stream >> number) || !stream.eof()) return std::nullopt;
  return number;
}

Pose pose_in(const std::string& text, const std::string& where)
{
  const std::vector<std::string> words = split(text, ',');
  double numbers[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::optional<double> number = words.size() == 3 ? number_in(words[i]) : std::nullopt;
    if (!number) throw std::runtime_error(where + ": '" + text + "' is no pose x,y,yaw");
    numbers[i] = *number;
  }
  return {numbers[0], numbers[1], numbers[2]};
}

/// The folder a file is in, with the slash that follows; empty for the working directory.
std::string folder_of(const std::string& path)
{
  return path.substr(0, path.find_last_of('/') + 1);
}

/// Which column has which name.
class Columns
{
public:
  explicit Columns(const std::string& header) : names_(split(header, ';')) {}

  std::size_t size() const { return names_.size(); }

  std::optional<std::size_t> find(const std::string& name) const
  {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
  }

  /// kUnknown where there is no such column, or no number in it.
  double number(const std::vector<std::string>& cells, const std::string& name) const
  {
    const std::optional<std::size_t> column = find(name);
    return column ? number_in(cells[*column]).value_or(kUnknown) : kUnknown;
  }

private:
  std::vector<std::string> names_;
};

}  // namespace

std::vector<Problem> read_problems(const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error(path + ": cannot be read, expected a file of problems");
  const Columns columns(line);
  const auto id = columns.find("id"), map = columns.find("map"), start = columns.find("start"),
             goal = columns.find("goal");
  if (!id || !map || !start || !goal) throw std::runtime_error(path + ":1: expected the columns id;map;start;goal");

  std::vector<Problem> problems;
  for (int number = 2; std::getline(file, line); ++number)
  {
    if (line.empty()) continue;
    const std::string where = path + ":" + std::to_string(number);
    const std::vector<std::string> cells = split(line, ';');
    if (cells.size() != columns.size())
      throw std::runtime_error(where + ": expected as many columns as the header has");
    Problem problem;
    problem.id = cells[*id];
    problem.map = cells[*map].front() == '/' ? cells[*map] : folder_of(path) + cells[*map];
    problem.start = pose_in(cells[*start], where);
    problem.goal = pose_in(cells[*goal], where);
    problem.peer_ms = columns.number(cells, "peer_frontend_cpu_ms");
    problem.peer_backend_ms = columns.number(cells, "peer_backend_cpu_ms");
    problem.peer_arrival_time = columns.number(cells, "peer_AT_s");
    problem.peer_length = columns.number(cells, "peer_TL_m");
    problems.push_back(problem);
  }
  return problems;
}

void write_problems(const std::string& path, const std::vector<Problem>& problems)
{
  std::ofstream file(path);
  file.imbue(std::locale::classic());
  file << std::fixed << std::setprecision(4) << "id;map;start;goal\n";
  for (const Problem& p : problems)
    file << p.id << ';' << p.map << ';' << p.start.x << ',' << p.start.y << ',' << p.start.theta << ';' << p.goal.x
         << ',' << p.goal.y << ',' << p.goal.theta << '\n';
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

const OccupancyGrid& MapCache::grid(const std::string& map)
{
  if (map != map_)
  {
    grid_ = read_map_file(map);
    map_ = map;
  }
  return grid_;
}

}  // namespace fourwis::benchmark
