#pragma once
// Lines in space with numbers on them as VTK poly data (.vtp), and collections of such files over time
// (.pvd).

#include "engine/base/result.h"

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace bask {

/// Numbers of points or lines, `components` each, point by point.
struct PolyArray {
    std::string name; ///< with its unit: "measured_K"
    std::vector<double> values;
    int components = 1;
};

/// Points (m), lines through them, and what is known of both.
struct PolyLines {
    std::string title; ///< says in words what they are
    std::vector<Eigen::Vector3d> points;
    std::vector<std::vector<int>> lines; ///< indices of points; a closed one ends where it begins
    std::vector<PolyArray> pointData;    ///< the first is shown at first
    std::vector<PolyArray> lineData;
    std::vector<std::pair<std::string, std::vector<std::string>>> words; ///< field data
};

/// Refuses a file that is there and is no poly data written by Bask (an empty one may go).
Result<void> checkPolyFile(const std::string& path);
/// Writes it, whole or not at all. Throws std::invalid_argument on arrays of another length. Errors:
/// FileUnwritable, and those of checkPolyFile.
Result<void> writePolyFile(const PolyLines& poly, const std::string& path);

/// A file of a collection, named from the collection's folder.
struct TimedFile {
    double time_s = 0.0;
    std::string name;
};

/// Text of a ParaView collection of files over time, marked as Bask's.
std::string collectionXml(const std::vector<TimedFile>& files);
/// Refuses a file that is there and is no collection written by Bask (an empty one may go).
Result<void> checkCollectionFile(const std::string& path);

} // namespace bask
