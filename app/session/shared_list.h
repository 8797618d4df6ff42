// SPDX-License-Identifier: MIT
// A list that grows at its end, with immutable views for other threads. Making a view is O(1), and later changes of the
// list do not affect it.
//
// Elements lie in one block, which views share. What a view may see is never written again: a list that was truncated, or
// copied, continues in a block of its own.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace pabd {

template <class T>
class SharedList {
 public:
  class View {
   public:
    View() = default;
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const T& operator[](std::size_t i) const { return block_.get()[first_ + i]; }
    const T& front() const { return (*this)[0]; }
    const T& back() const { return (*this)[size_ - 1]; }
    const T* begin() const { return block_.get() + first_; }
    const T* end() const { return begin() + size_; }
    operator std::span<const T>() const { return {begin(), size_}; }

   private:
    friend class SharedList;
    View(std::shared_ptr<const T[]> block, std::size_t first, std::size_t size)
        : block_(std::move(block)), first_(first), size_(size) {}

    std::shared_ptr<const T[]> block_;
    std::size_t first_ = 0, size_ = 0;
  };

  SharedList() = default;
  SharedList(const SharedList& other)
      : block_(other.block_), room_(other.room_), first_(other.first_), size_(other.size_) {}
  SharedList& operator=(const SharedList& other) { return *this = SharedList(other); }
  SharedList(SharedList&& other) noexcept { swap(other); }
  SharedList& operator=(SharedList&& other) noexcept {
    swap(other);
    return *this;
  }
  ~SharedList() = default;

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const { return block_[first_ + i]; }
  const T& back() const { return (*this)[size_ - 1]; }
  const T* begin() const { return block_.get() + first_; }
  const T* end() const { return begin() + size_; }

  View view() const { return {block_, first_, size_}; }

  // Amortised O(1).
  void push_back(T value) {
    if (!own_ || first_ + size_ == room_) move_on();
    block_[first_ + size_++] = std::move(value);
  }
  // Only the first `size` stay. Precondition: there are as many.
  void truncate(std::size_t size) {
    if (size < size_) own_ = false;
    size_ = size;
  }
  // Without the first `count`. Precondition: there are as many.
  void drop_front(std::size_t count) {
    first_ += count;
    size_ -= count;
  }

 private:
  // Copies into a block of its own, with room for as many again.
  void move_on() {
    const std::size_t room = std::max<std::size_t>(16, 2 * size_);
    const std::shared_ptr<T[]> block(new T[room]);
    std::copy(begin(), end(), block.get());
    block_ = block;
    room_ = room;
    first_ = 0;
    own_ = true;
  }
  void swap(SharedList& other) noexcept {
    std::swap(block_, other.block_);
    std::swap(room_, other.room_);
    std::swap(first_, other.first_);
    std::swap(size_, other.size_);
    std::swap(own_, other.own_);
  }

  std::shared_ptr<T[]> block_;
  std::size_t room_ = 0;  // elements in the block
  std::size_t first_ = 0, size_ = 0;
  bool own_ = false;  // no view sees what lies behind the end
};

}  // namespace pabd
