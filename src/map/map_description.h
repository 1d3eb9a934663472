#pragma once

#include <string>

#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// How map_server turns a pixel into a cell.
enum class ValueMode
{
  trinary,
  scale,
  raw
};

/// What the YAML file of a map says.
struct MapDescription
{
  std::string image;
  double resolution = 0.0;
  Pose origin;
  bool negate = false;
  double occupied_thresh = 0.0;
  double free_thresh = 0.0;
  ValueMode mode = ValueMode::trinary;
};

/// Throws MapFileError.
MapDescription read_map_description(const std::string& path);

}  // namespace fourwis
