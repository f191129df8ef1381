#pragma once
// Result<T>: a value or an Error, for failures that are expected (a file, an answer, an unreachable target).

#include "engine/base/message.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace bask {

/// An expected failure: the message, and the place of the failure (file, line, JSON path); `where` may be
/// empty.
struct Error {
    Message message;
    std::string where;

    Error() = default;
    Error(MessageCode code, std::string place, std::vector<MessageArg> args = {})
        : message{code, std::move(args)}, where(std::move(place)) {}

    MessageCode code() const { return message.code; }
};

/// Returns "where: sentence" in English, for the command line and logs.
std::string describe(const Error& error);

/// A value or an Error. Reading the one that is absent is a broken contract and throws std::logic_error.
template <class T> class [[nodiscard]] Result {
public:
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return m_state.index() == 0; }
    explicit operator bool() const { return ok(); }

    const T& value() const& { return check(), std::get<0>(m_state); }
    T& value() & { return check(), std::get<0>(m_state); }
    T&& value() && { return check(), std::get<0>(std::move(m_state)); }
    const T& operator*() const& { return value(); }
    T& operator*() & { return value(); }
    const T* operator->() const { return &value(); }
    T* operator->() { return &value(); }

    const Error& error() const {
        if (ok())
            throw std::logic_error("Result: error() asked of a success");
        return std::get<1>(m_state);
    }

private:
    void check() const {
        if (!ok())
            throw std::logic_error("Result: value() asked of a failure: " + describe(std::get<1>(m_state)));
    }
    std::variant<T, Error> m_state;
};

/// Success without a value, or an Error.
template <> class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : m_error(std::move(error)) {}

    bool ok() const { return !m_error; }
    explicit operator bool() const { return ok(); }
    const Error& error() const {
        if (ok())
            throw std::logic_error("Result: error() asked of a success");
        return *m_error;
    }

private:
    std::optional<Error> m_error;
};

} // namespace bask
