#include "engine/media/media.h"

#include "engine/base/program_part.h"
#include "engine/media/painting.h"

#include <cstdio>
#include <stdexcept>

namespace bask {
namespace {

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "bask: %s; install Bask again\n", what.c_str());
    throw std::runtime_error(what);
}

/// A function of a module, which stays loaded.
template <class Function> Function* functionOf(const char* module, const char* name) {
    std::string problem;
    void* const found = moduleFunction(module, BASK_MODULES_BUILT, name, problem);
    if (found == nullptr)
        fail(problem);
    return reinterpret_cast<Function*>(found);
}

} // namespace

const PictureCodecs& pictureCodecs() {
    static const auto kCodecs = functionOf<const PictureCodecs*()>("bask-pictures.so", "baskPictureCodecs");
    return *kCodecs();
}

std::unique_ptr<VideoInput> makeVideoInput() {
    static const auto kMake = functionOf<VideoInput*()>("bask-video.so", "baskMakeVideoInput");
    return std::unique_ptr<VideoInput>(kMake());
}

const Painting& painting() {
    static const auto kPainting = functionOf<const Painting*()>("bask-painting.so", "baskPainting");
    return *kPainting();
}

int fourCharacterCode(const std::string& letters) {
    int code = 0;
    for (std::size_t k = 0; k < 4; ++k)
        code |= static_cast<int>(static_cast<unsigned char>(letters[k])) << (8 * k);
    return code;
}

} // namespace bask
