#pragma once
// Builds an HDF5 file: groups, numbers with units, texts, attributes, links. It is built in memory, so that a
// full disk never leaves an incomplete file; pictures are filled in on the disk.

#include "engine/base/result.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bask {

/// A finished file but for its rooms.
struct Hdf5Sparse {
    std::uint64_t size = 0;           ///< of the whole file, bytes
    std::vector<std::uint64_t> rooms; ///< where each begins, in the order of their making
    std::vector<std::pair<std::uint64_t, std::string>> pieces; ///< what is between them: offset and bytes
};

/// Paths are absolute, "/entry/title"; create a group before its contents. The first failure of the library
/// is stored and returned by image(). Only one exists at a time, because the library is not thread-safe;
/// others wait until it is destroyed.
class Hdf5File {
public:
    enum class Backing {
        Memory,
        Sparse ///< memory too, but none for what is in rooms
    };
    /// `roomSizes`: those of all rooms that will be added.
    explicit Hdf5File(Backing backing = Backing::Memory,
                      const std::vector<std::vector<std::size_t>>& roomSizes = {});
    ~Hdf5File();

    /// Returns the version of the HDF5 library: "1.10.8".
    static std::string libraryVersion();

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
    void wholeNumber(const std::string& path, int value, const std::string& units);
    void wholeNumbers(const std::string& path, std::span<const int> values, const std::string& units);
    /// Adds room for `count` pictures of 16 bits: [count, rows, columns], each a chunk of its own, compressed
    /// without loss. Hdf5Pictures fills it.
    void pictures(const std::string& path, std::size_t count, int rows, int columns);
    /// Adds numbers [sizes...] that are written into the file later, without the library. They are in chunks
    /// of about a megabyte, each a range of the numbers, one after another: in the file they lie in their own
    /// order, in one piece. Only with Backing::Sparse.
    void room(const std::string& path, const std::vector<std::size_t>& sizes, const std::string& units);
    /// Adds another name for something that exists.
    void link(const std::string& there, const std::string& path);

    /// Returns the bytes of the finished file. Error: FileUnwritable at `where`, if the library reported a
    /// failure.
    Result<std::string> image(const std::string& where);

    /// Ends the file and returns it without the bytes of its rooms. Error: as image().
    Result<Hdf5Sparse> sparse(const std::string& where);

    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Fills the pictures of a finished file, one after another, so that memory holds one at a time. Shares the
/// library with Hdf5File: they wait for each other.
class Hdf5Pictures {
public:
    /// Opens the pictures at `path` of the file `file`. A failure is stored and returned by close().
    Hdf5Pictures(const std::string& file, const std::string& path);
    /// A file that was not closed is unusable.
    ~Hdf5Pictures();

    /// Writes the next picture, row by row; no effect after a failure.
    void add(std::span<const unsigned short> values);
    /// Writes what is left. Error: FileUnwritable at `where`; the file is then unusable.
    Result<void> close(const std::string& where);

    Hdf5Pictures(const Hdf5Pictures&) = delete;
    Hdf5Pictures& operator=(const Hdf5Pictures&) = delete;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace bask
