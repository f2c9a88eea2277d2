#include "program/files/sha256.hpp"

#include "program/files/system_file.hpp"

#include <array>
#include <cstdint>

namespace app {
namespace {

using Words = std::array<uint32_t, 8>;

// The first 32 bits of the fractional parts of the square roots of the first 8 primes, and of the cube roots of the first 64.
constexpr Words kStart = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
constexpr std::array<uint32_t, 64> kRound = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5, 0xd807aa98, 0x12835b01,
    0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc,
    0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da, 0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147,
    0x06ca6351, 0x14292967, 0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070, 0x19a4c116, 0x1e376c08,
    0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3, 0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208,
    0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

uint32_t turned(uint32_t x, int by) { return x >> by | x << (32 - by); }

void add_block(const unsigned char* block, Words& hash) {
  std::array<uint32_t, 64> w{};
  for (size_t i = 0; i < 16; ++i)
    for (size_t k = 0; k < 4; ++k) w[i] = w[i] << 8 | block[4 * i + k];
  for (size_t i = 16; i < 64; ++i) {
    const uint32_t a = w[i - 15], b = w[i - 2];
    w[i] = w[i - 16] + (turned(a, 7) ^ turned(a, 18) ^ a >> 3) + w[i - 7] + (turned(b, 17) ^ turned(b, 19) ^ b >> 10);
  }
  Words v = hash;
  for (size_t i = 0; i < 64; ++i) {
    const uint32_t mix = turned(v[4], 6) ^ turned(v[4], 11) ^ turned(v[4], 25), choice = (v[4] & v[5]) ^ (~v[4] & v[6]);
    const uint32_t one = v[7] + mix + choice + kRound[i] + w[i];
    const uint32_t other = turned(v[0], 2) ^ turned(v[0], 13) ^ turned(v[0], 22),
                   majority = (v[0] & v[1]) ^ (v[0] & v[2]) ^ (v[1] & v[2]);
    for (size_t k = 7; k > 0; --k) v[k] = v[k - 1];
    v[4] += one, v[0] = one + other + majority;
  }
  for (size_t k = 0; k < 8; ++k) hash[k] += v[k];
}

} // namespace

std::string sha256_of(const std::string& text) {
  std::string all = text;
  all += '\x80';
  while (all.size() % 64 != 56) all += '\0';
  for (int shift = 56; shift >= 0; shift -= 8) all += static_cast<char>(uint64_t{text.size()} * 8 >> shift & 0xff);
  Words hash = kStart;
  for (size_t at = 0; at < all.size(); at += 64) add_block(reinterpret_cast<const unsigned char*>(all.data()) + at, hash);
  std::string out;
  for (const uint32_t word : hash)
    for (int shift = 28; shift >= 0; shift -= 4) out += "0123456789abcdef"[word >> shift & 15];
  return out;
}

InputFile input_file(const std::string& name, const std::string& text) {
  return {name.substr(begin_of_name(name)), sha256_of(text)};
}

} // namespace app
