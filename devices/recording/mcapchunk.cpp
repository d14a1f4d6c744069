// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/mcapchunk.h"

#include <lz4frame.h>
#include <memory>
#include <zstd.h>

namespace mb::mcap {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint64_t largestChunk = 256U << 20U;

bool unpackZstd(std::span<const std::uint8_t> packed, Bytes &out)
{
    return ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size()) == out.size();
}

bool unpackLz4(std::span<const std::uint8_t> packed, Bytes &out)
{
    LZ4F_dctx *made = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0)
        return false;
    const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
        made, LZ4F_freeDecompressionContext);
    std::size_t done = 0;
    while (!packed.empty() && done < out.size()) {
        std::size_t taken = packed.size();
        std::size_t given = out.size() - done;
        const std::size_t hint
            = LZ4F_decompress(context.get(), out.data() + done, &given, packed.data(), &taken, nullptr);
        if (LZ4F_isError(hint) != 0 || (taken == 0 && given == 0))
            return false;
        packed = packed.subspan(taken);
        done += given;
    }
    return done == out.size();
}

} // namespace

Result<std::vector<std::uint8_t>> recordsOf(View chunk)
{
    (void)chunk.get<std::uint64_t>(); // times of its first and last message
    (void)chunk.get<std::uint64_t>();
    const auto size = chunk.get<std::uint64_t>();
    (void)chunk.get<std::uint32_t>(); // checksum
    const std::string how = chunk.text();
    const auto packed = chunk.take(static_cast<std::size_t>(chunk.get<std::uint64_t>()));
    if (!chunk.ok())
        return fail(Fault::OutOfRange, say("a chunk of it is damaged"));
    if (size > largestChunk)
        return fail(Fault::OutOfRange, say("a chunk of it is larger than %1 MB", largestChunk >> 20U));
    if (how.empty())
        return Bytes(packed.begin(), packed.end());
    if (how != "zstd" && how != "lz4")
        return fail(Fault::OutOfRange, say("its chunks are packed by '%1'; zstd and lz4 are known", how));
    Bytes out(size);
    if (!(how == "zstd" ? unpackZstd(packed, out) : unpackLz4(packed, out)))
        return fail(Fault::OutOfRange, say("a chunk of it is damaged"));
    return out;
}

} // namespace mb::mcap
