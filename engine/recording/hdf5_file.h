#pragma once
// Builds an HDF5 file: groups, numbers with units, texts, attributes, links. It is built in memory, so that a
// full disk never leaves an incomplete file.

#include "engine/base/result.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace bask {

/// Paths are absolute, "/entry/title"; create a group before its contents. The first failure of the library
/// is stored and returned by image(). Only one exists at a time, because the library is not thread-safe;
/// others wait until it is destroyed.
class Hdf5File {
public:
    Hdf5File();
    ~Hdf5File();

    /// Creates a group with its NX_class.
    void group(const std::string& path, const std::string& nxClass);
    /// Adds an attribute to a group or a data set.
    void attribute(const std::string& path, const std::string& name, const std::string& text);
    void attribute(const std::string& path, const std::string& name, const std::vector<std::string>& texts);
    void text(const std::string& path, const std::string& text);
    void texts(const std::string& path, const std::vector<std::string>& texts);
    /// Adds a number; `units` are in SI, "1" for a number without a unit.
    void number(const std::string& path, double value, const std::string& units);
    void numbers(const std::string& path, std::span<const double> values, const std::string& units);
    void wholeNumbers(const std::string& path, std::span<const int> values, const std::string& units);
    /// Adds another name for something that exists.
    void link(const std::string& there, const std::string& path);

    /// Returns the bytes of the finished file. Error: FileUnwritable at `where`, if the library reported a
    /// failure.
    Result<std::string> image(const std::string& where);

    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace bask
