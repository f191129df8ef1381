#pragma once
// Lines in space with data as VTK poly data (.vtp), and collections of such files over time (.pvd).

#include "engine/base/result.h"

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace bask {

/// Data of points or lines, `components` numbers for each, point by point.
struct PolyArray {
    std::string name; ///< with its unit: "measured_K"
    std::vector<double> values;
    int components = 1;
};

/// Points (m), lines through them, and data of both.
struct PolyLines {
    std::string title; ///< describes them in words
    std::vector<Eigen::Vector3d> points;
    std::vector<std::vector<int>> lines; ///< indices of points; a closed line ends at its first point
    std::vector<PolyArray> pointData;    ///< the first one is displayed by default
    std::vector<PolyArray> lineData;
    std::vector<std::pair<std::string, std::vector<std::string>>> words; ///< field data
};

/// Refuses an existing file that is not poly data written by Bask (an empty one may be replaced).
Result<void> checkPolyFile(const std::string& path);
/// Writes it completely or not at all. Throws std::invalid_argument for arrays of a wrong length. Errors:
/// FileUnwritable, and those of checkPolyFile.
Result<void> writePolyFile(const PolyLines& poly, const std::string& path);

/// A file of a collection, with its path from the collection's folder.
struct TimedFile {
    double time_s = 0.0;
    std::string name;
};

/// Returns the text of a ParaView collection of files over time, marked as Bask's.
std::string collectionXml(const std::vector<TimedFile>& files);
/// Refuses an existing file that is not a collection written by Bask (an empty one may be replaced).
Result<void> checkCollectionFile(const std::string& path);

} // namespace bask
