#include "barn_map.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "fourwis_navigation/map/map_file.h"

namespace fourwis::benchmark
{
namespace
{

namespace fs = std::filesystem;

constexpr double kCell = 0.15;  ///< side of a cell of the dataset [m]
const std::string kPrefix = "map_pgm_";

/// A folder that is gone when this is.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string pattern = (fs::temp_directory_path() / "fourwis_XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error(pattern + ": cannot be created");
    path_ = pattern;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder()
  {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  const fs::path& path() const { return path_; }

private:
  fs::path path_;
};

/// The dataset has images only; the description is ours.
OccupancyGrid read_image(const fs::path& image, const fs::path& folder)
{
  const std::string yaml = (folder / "map.yaml").string();
  std::ofstream file(yaml);
  file << "image: " << fs::absolute(image).string() << "\nresolution: " << kCell
       << "\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  file.close();
  return read_map_file(yaml);
}

int number_of(const fs::path& image)
{
  return std::atoi(image.stem().string().c_str() + kPrefix.size());
}

std::vector<fs::path> images_in(const std::string& folder)
{
  std::vector<fs::path> images;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
  {
    const fs::path& path = entry.path();
    if (path.extension() == ".pgm" && path.stem().string().compare(0, kPrefix.size(), kPrefix) == 0)
      images.push_back(path);
  }
  std::sort(images.begin(), images.end(),
            [](const fs::path& a, const fs::path& b) { return number_of(a) < number_of(b); });
  if (images.empty()) throw std::runtime_error(folder + ": no map_pgm_*.pgm in it");
  return images;
}

}  // namespace

std::vector<BarnMap> read_barn_maps(const std::string& folder, double margin)
{
  const TemporaryFolder scratch;
  std::vector<BarnMap> maps;
  for (const fs::path& image : images_in(folder))
  {
    BarnMap map;
    map.name = image.stem().string();
    map.grid = read_image(image, scratch.path());
    map.top = map.grid.height * map.grid.resolution;
    map.grid.height += static_cast<int>(std::ceil(margin / map.grid.resolution));
    map.grid.data.resize(static_cast<std::size_t>(map.grid.width) * static_cast<std::size_t>(map.grid.height), 0);
    maps.push_back(std::move(map));
  }
  return maps;
}

}  // namespace fourwis::benchmark
