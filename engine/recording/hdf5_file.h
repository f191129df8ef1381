#pragma once
// An HDF5 file being made: groups, numbers with units, texts, attributes, links. It grows in memory, so that
// a full disk never leaves half of one.

#include "engine/base/result.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace bask {

/// Paths are absolute, "/entry/title"; a group comes before what is in it. The library's first failure is
/// kept and told by image(). One at a time: the library is not made for threads; others wait for this one's
/// end.
class Hdf5File {
public:
    Hdf5File();
    ~Hdf5File();

    /// A group with its NX_class.
    void group(const std::string& path, const std::string& nxClass);
    /// On a group or a data set.
    void attribute(const std::string& path, const std::string& name, const std::string& text);
    void attribute(const std::string& path, const std::string& name, const std::vector<std::string>& texts);
    void text(const std::string& path, const std::string& text);
    void texts(const std::string& path, const std::vector<std::string>& texts);
    /// `units` as in SI, "1" of what has none.
    void number(const std::string& path, double value, const std::string& units);
    void numbers(const std::string& path, std::span<const double> values, const std::string& units);
    void wholeNumbers(const std::string& path, std::span<const int> values, const std::string& units);
    /// Another name of something that is there.
    void link(const std::string& there, const std::string& path);

    /// The finished file's bytes. Error: FileUnwritable at `where`, when the library refused something.
    Result<std::string> image(const std::string& where);

    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace bask
