// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/decode.h"

#include "families/dmc60c/codec.h"
#include "families/dmc60c/parameters.h"
#include "wire/bytes.h"
#include "wire/fixedpoint.h"

#include <algorithm>

namespace mb::dmc60c {
namespace {

/// One field of a message; unit and word follow from the frame (the mode, the parameter), or the unit is fixed.
struct Field {
    std::string_view name;
    double (*value)(const CanFrame &) = nullptr;
    std::string_view unit{};
    std::string_view (*unitIn)(const CanFrame &) = nullptr;
    std::string_view (*wordIn)(const CanFrame &) = nullptr;
};

struct Layout {
    std::uint32_t base = 0;
    int size = 0; ///< −1: 1…8
    std::string_view name;
    bool control = false;
    std::span<const Field> fields;
};

template <int At> double u8(const CanFrame &f)
{
    return f.data[At];
}
template <int At> double u16(const CanFrame &f)
{
    return readU16le(f.data, At);
}
template <int At> double i16(const CanFrame &f)
{
    return signExtend(readU16le(f.data, At), 16);
}
template <int At> double u32(const CanFrame &f)
{
    return readU32le(f.data, At);
}
template <int At> double fixed8x8(const CanFrame &f)
{
    return fromFixed(signExtend(readU16le(f.data, At), 16), 256.0);
}
template <int At, int First, int Width = 1> double bits(const CanFrame &f)
{
    return (f.data[At] >> First) & ((1 << Width) - 1);
}

constexpr std::string_view duty = "1/32767";

std::string_view unitOfMode(ControlMode mode)
{
    switch (mode) {
    case ControlMode::Voltage: return duty;
    case ControlMode::Velocity: return "counts/100 ms";
    case ControlMode::Position: return "counts";
    case ControlMode::Current: return "A";
    case ControlMode::VoltageCompensated: return "V";
    case ControlMode::Follower:
    case ControlMode::NoDrive: break;
    }
    return {};
}

std::string_view wordOfMode(ControlMode mode)
{
    switch (mode) {
    case ControlMode::Voltage: return "duty";
    case ControlMode::Velocity: return "velocity";
    case ControlMode::Position: return "position";
    case ControlMode::Current: return "current";
    case ControlMode::VoltageCompensated: return "voltage";
    case ControlMode::Follower: return "follow";
    case ControlMode::NoDrive: return "off";
    }
    return {};
}

ControlMode modeOfControl(const CanFrame &f)
{
    return static_cast<ControlMode>(f.data[0] & 0xFU);
}
ControlMode modeOfStatus(const CanFrame &f)
{
    return static_cast<ControlMode>((f.data[4] >> 3U) & 0xFU);
}

double target(const CanFrame &f)
{
    const std::int32_t raw = signExtend((std::uint32_t{f.data[3]} << 16U) | readU16le(f.data, 4), 24);
    switch (modeOfControl(f)) {
    case ControlMode::Voltage: return i16<4>(f);
    case ControlMode::Follower: return f.data[4];
    case ControlMode::Current:
    case ControlMode::VoltageCompensated: return fromFixed(raw, 65536.0);
    default: return raw;
    }
}

double generalError(const CanFrame &f)
{
    return errorOf(decodeStatusGeneral(f).value_or(StatusGeneral()));
}
double position(const CanFrame &f)
{
    return decodeStatusEncoder(f).value_or(StatusEncoder()).position;
}
double velocity(const CanFrame &f)
{
    return decodeStatusEncoder(f).value_or(StatusEncoder()).velocity;
}

/// The value field at `At` of the parameter whose number is at `Number`.
template <int Number, int At> double parameterValue(const CanFrame &f)
{
    const std::uint32_t field = readU32le(f.data, At);
    const auto index = parameterWithId(f.data[Number]);
    if (!index)
        return fromFixed(rawOf(WireType::Int32, field), 1.0);
    const Parameter &p = parameterTable()[index->value];
    return fromFixed(rawOf(p.type, field), p.one);
}
template <int Number> std::string_view parameterUnit(const CanFrame &f)
{
    const auto index = parameterWithId(f.data[Number]);
    return index ? parameterTable()[index->value].unit : std::string_view{};
}

template <int Number> std::string_view parameterKey(const CanFrame &f)
{
    const auto index = parameterWithId(f.data[Number]);
    return index ? parameterTable()[index->value].key : std::string_view{};
}

constexpr Field enumResponse0[] = {{"sessid", u16<0>}, {"pdid", u32<2>}};
constexpr Field enumResponse1[] = {
    {"sessid", u16<0>},
    {"imgtyp", bits<2, 0, 2>},
    {"fwverApp", u16<4>},
    {"fwverBoot", u16<6>},
};
constexpr Field vendorCommand[] = {{"sessid", u16<0>}, {"cmd", u16<2>}, {"PARAM1", u16<4>}, {"PARAM2", u16<6>}};
constexpr Field vendorStatus[] = {{"cerc", u8<0>}, {"terc", u8<1>}, {"cb", u16<2>}};
constexpr Field bulk[] = {
    {"byte0", u8<0>},
    {"byte1", u8<1>},
    {"byte2", u8<2>},
    {"byte3", u8<3>},
    {"byte4", u8<4>},
    {"byte5", u8<5>},
    {"byte6", u8<6>},
    {"byte7", u8<7>},
};
constexpr Field paramRequest[] = {{"sessid", u16<0>}, {"paramid", u8<2>, {}, nullptr, parameterKey<2>}};
constexpr Field paramSet[] = {{"sessid", u16<0>}, {"paramid", u8<2>, {}, nullptr, parameterKey<2>},
    {"value", parameterValue<2, 3>, {}, parameterUnit<2>}};
constexpr Field paramResponse[] = {{"paramid", u8<0>, {}, nullptr, parameterKey<0>},
    {"value", parameterValue<0, 1>, {}, parameterUnit<0>}, {"perc", u8<5>}};
constexpr Field statusGeneral[] = {
    {"dtcApplied", i16<0>, duty},
    {"fFwdLimitPin", bits<2, 0>},
    {"fFwdLimitHit", bits<2, 1>},
    {"fFwdLimitDisabled", bits<2, 2>},
    {"fFwdLimitNormalClosed", bits<2, 3>},
    {"fRevLimitPin", bits<2, 4>},
    {"fRevLimitHit", bits<2, 5>},
    {"fRevLimitDisabled", bits<2, 6>},
    {"fRevLimitNormalClosed", bits<2, 7>},
    {"fFwdRevLimitOverride", bits<3, 0>},
    {"fFwdLimitDisableOvrd", bits<3, 1>},
    {"fRevLimitDisableOvrd", bits<3, 2>},
    {"fSoftFwdLimitHit", bits<3, 3>},
    {"fSoftFwdLimitEnabled", bits<3, 4>},
    {"fSoftRevLimitHit", bits<3, 5>},
    {"fSoftRevLimitEnabled", bits<3, 6>},
    {"fCurrentLimitActive", bits<3, 7>},
    {"fOverTempFault", bits<4, 0>},
    {"fUnderVoltageFault", bits<4, 1>},
    {"fGateDriverFault", bits<4, 2>},
    {"modeSelect", bits<4, 3, 4>, {}, nullptr, [](const CanFrame &f) { return wordOfMode(modeOfStatus(f)); }},
    {"fDivErrBy256", bits<4, 7>},
    {"errCLoop", generalError, {}, [](const CanFrame &f) { return unitOfMode(modeOfStatus(f)); }},
};
constexpr Field statusEncoder[] = {
    {"poscnt", position, "counts"},
    {"velcnt", velocity, "counts/100 ms"},
    {"fDivPosBy8", bits<7, 0>},
    {"fDivVelBy4", bits<7, 1>},
    {"fQEAPin", bits<7, 2>},
    {"fQEBPin", bits<7, 3>},
    {"fQEIdxPin", bits<7, 4>},
};
constexpr Field statusAnalog[] = {
    {"vltgAnalogIn", fixed8x8<0>, "V"},
    {"crntOutput", fixed8x8<2>, "A"},
    {"tmpAmbient", fixed8x8<4>, "°C"},
    {"vltgVbus", fixed8x8<6>, "V"},
};
constexpr Field control[] = {
    {"modeSelect", bits<0, 0, 4>, {}, nullptr, [](const CanFrame &f) { return wordOfMode(modeOfControl(f)); }},
    {"fOverrideBC", bits<0, 4>},
    {"fBrakeCoast", bits<0, 5>},
    {"pidsltSelect", bits<0, 6>},
    {"fRevFeedbackSensor", bits<0, 7>},
    {"fRevMotor", bits<1, 0>},
    {"fDisableFwdLimit", bits<1, 1>},
    {"fDisableRevLimit", bits<1, 2>},
    {"fEnableLimitOverride", bits<1, 3>},
    {"trgt", target, {}, [](const CanFrame &f) { return unitOfMode(modeOfControl(f)); }},
    {"vltgRampSet", u16<6>, "1/32767 per 0.5 ms"},
};

constexpr Layout layouts[] = {
    {id::statusGeneral, 8, "STSGENERAL", false, statusGeneral},
    {id::statusEncoder, 8, "STSENCODER", false, statusEncoder},
    {id::statusAnalog, 8, "STSANALOG", false, statusAnalog},
    {id::control, 8, "CANCTRL0", true, control},
    {id::paramRequest, 3, "PARAMREQ", false, paramRequest},
    {id::paramSet, 7, "PARAMSET", false, paramSet},
    {id::paramResponse, 6, "PARAMRESP", false, paramResponse},
    {id::vendorCommand, 8, "VENDORCMD", false, vendorCommand},
    {id::vendorStatus, 4, "VENDORSTS", false, vendorStatus},
    {id::vendorDout, -1, "VENDORDOUT", false, bulk},
    {id::vendorDin, -1, "VENDORDIN", false, bulk},
    {id::enumerate, 0, "ENUM", false, {}},
    {id::enumResponse, 6, "ENUMRSP0", false, enumResponse0},
    {id::enumResponse, 8, "ENUMRSP1", false, enumResponse1},
};

bool matches(const Layout &layout, const CanFrame &frame)
{
    if (layout.size < 0)
        return frame.size > 0 && isMessage(frame, layout.base, frame.size);
    return isMessage(frame, layout.base, static_cast<std::size_t>(layout.size));
}

} // namespace

std::optional<DecodedFrame> decodeCan(const CanFrame &frame, std::string_view)
{
    const auto *const layout
        = std::find_if(std::begin(layouts), std::end(layouts), [&](const Layout &l) { return matches(l, frame); });
    if (layout == std::end(layouts))
        return std::nullopt;
    DecodedFrame decoded{"dmc60c", layout->name, deviceOf(frame), layout->control, {}};
    const auto fields = layout->size < 0 ? layout->fields.first(frame.size) : layout->fields;
    decoded.fields.reserve(fields.size());
    for (const Field &field : fields)
        decoded.fields.push_back({field.name, field.value(frame), field.unitIn ? field.unitIn(frame) : field.unit,
            field.wordIn ? field.wordIn(frame) : std::string_view{}});
    return decoded;
}

} // namespace mb::dmc60c
