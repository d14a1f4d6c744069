// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/flashproof.h"

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

constexpr Duration tolerance = 1s; ///< of the 15 s, and for the time a flash write takes with its repeats

} // namespace

void FlashProof::changed(Instant now)
{
    // Within the tolerance of 15 s it may be a write of its own: expecting one too many is safe, one too few is not.
    const bool rested = !m_everChanged || now - m_lastChange > flashDelay - tolerance;
    if (wantsBaseline()) {
        m_expected = 0;
        m_deferred = false;
    }
    if (rested) {
        ++m_expected;
        m_deferred = false;
    } else if (!m_deferred) {
        ++m_expected;
        m_deferred = true;
    }
    m_pending = true;
    m_isGivenUp = false;
    m_isOthers = false;
    m_everChanged = true;
    m_between.reset();
    m_lastChange = now;
}

void FlashProof::ask(Instant now)
{
    if (m_pending || !m_unknownUntil || now - *m_unknownUntil > flashDelay + tolerance)
        return;
    m_pending = true;
    m_isOthers = true;
    m_lastChange = *m_unknownUntil;
}

bool FlashProof::hasRested(Instant now) const
{
    return m_isOthers && now - m_lastChange > flashDelay + tolerance;
}

bool FlashProof::isProvedBy(std::uint32_t sequence, Instant now)
{
    if (m_baseline && sequence - *m_baseline >= m_expected)
        return true;
    const Duration age = now - m_lastChange;
    if (m_between)
        return sequence != *m_between;
    if (age >= tolerance && age <= flashDelay - tolerance)
        m_between = sequence;
    return false;
}

void FlashProof::settle()
{
    m_pending = false;
    m_isGivenUp = false;
    m_isOthers = false;
    m_unknownUntil.reset();
    m_baseline.reset();
}

void FlashProof::restarted()
{
    settle();
    m_everChanged = false; // so that it writes the next change at once, however young the last one is
}

} // namespace mb::dmc60c
