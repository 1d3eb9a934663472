#pragma once

#include <map>

#include "map_bytes.h"

namespace fourwis
{

/// A map of which single fields can be changed; an empty text leaves a field out.
class MapFixture : public testing::Test
{
protected:
  std::string write_yaml(const std::map<std::string, std::string>& changes = {}) const
  {
    std::map<std::string, std::string> fields{{"image", "map.pgm"},         {"resolution", "0.05"},
                                              {"origin", "[-1, 2.5, 0.3]"}, {"negate", "0"},
                                              {"occupied_thresh", "0.65"},  {"free_thresh", "0.196"}};
    for (const auto& change : changes) fields[change.first] = change.second;
    std::string text;
    for (const auto& field : fields) text += field.second.empty() ? "" : field.first + ": " + field.second + "\n";
    write_bytes(folder_ / "map.yaml", text);
    return folder_ / "map.yaml";
  }

  OccupancyGrid read_image_bytes(const std::string& bytes, const std::map<std::string, std::string>& changes = {}) const
  {
    write_bytes(folder_ / "map.pgm", bytes);
    return read_map_file(write_yaml(changes));
  }

  std::string rejection_of_image(const std::string& bytes) const
  {
    return message_of([&] { read_image_bytes(bytes); });
  }

  TemporaryDirectory folder_;
};

inline std::string pgm(int width, int height, const std::string& samples)
{
  return "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" + samples;
}

inline const std::string small_pgm = pgm(3, 2, std::string("\x00\xfe\xcd\xfe\xfe\x00", 6));
inline const std::vector<std::int8_t> small_cells{0, 0, 100, 100, 0, -1};

}  // namespace fourwis
