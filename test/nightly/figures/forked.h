#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace fourwis::nightly
{

/// Does work(0) to work(count - 1) in a child process and hands what each returns to done(). Where the child dies, crashed() is
/// told at which, and another child goes on behind it: figures must come also where the planner crashes.
void in_child(std::size_t count, const std::function<std::string(std::size_t)>& work,
              const std::function<void(std::size_t, const std::string&)>& done,
              const std::function<void(std::size_t)>& crashed);

}  // namespace fourwis::nightly
