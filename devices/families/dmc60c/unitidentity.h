// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/codec.h"
#include "model/identity.h"

#include <optional>

/// What answers on the wire say about a unit, as an Identity.
namespace mb::dmc60c {

/// A complete answer to the enumeration, without descriptors.
[[nodiscard]] Identity identityOf(const EnumResponse0 &first, const EnumResponse1 &second);
/// Family::recogniser: who sent this, and what it says of itself.
[[nodiscard]] std::optional<Identity> recognise(const CanFrame &frame);
/// State, versions and detail from an answer to GetFwver; all else stays. A duplicate stays one.
void setVersions(Identity &identity, const FirmwareVersions &versions);
/// Name, serial number and the list of descriptors.
void setDescriptors(Identity &identity, const DescriptorList &list);
/// What setDescriptors() gave `from`.
void carryDescriptors(Identity &to, const Identity &from);
/// `units` devices share this number.
void markDuplicate(Identity &identity, int units);

} // namespace mb::dmc60c
