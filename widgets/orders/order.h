// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/orders/deviceorders.h"
#include "widgets/orders/firmwareorders.h"
#include "widgets/orders/linkorders.h"
#include "widgets/orders/motionorders.h"
#include "widgets/orders/parameterorders.h"
#include "widgets/orders/recordingorders.h"
#include "widgets/orders/serviceorders.h"
#include "widgets/orders/settingsorders.h"
#include "widgets/orders/trialorders.h"

#include <cstddef>
#include <variant>

namespace mb {

namespace detail {

template <class... O> struct Kinds {
    static constexpr std::size_t count = sizeof...(O);
};
template <class... A, class... B, class... C>
std::variant<A..., B..., C...> oneOf(Kinds<A...>, Kinds<B...>, Kinds<C...>);

} // namespace detail

/// These turn a motor, or let one be turned. A stop of whatever cause takes back those that wait: they are answered with Cancelled.
using MovingOrders = detail::Kinds<orders::StartMotion, orders::UpdateMotion, orders::ReleaseMoves,
    orders::RunExperiment, orders::RunTrial, orders::RunTuning, orders::RunSweep, orders::ArmService>;
/// What the user's STOP ends or cannot judge: begins or goes on serving units, whose motors turn later, or says to a bus what nobody
/// may know. Only that STOP takes back those that wait.
using StoppableOrders
    = detail::Kinds<orders::SendFrame, orders::ServeUnits, orders::RetryUnit, orders::RetryFailedUnits>;
/// Nothing turns by these, or what they do asks itself whether it stands.
using StillOrders = detail::Kinds<orders::OpenLink, orders::CloseLink, orders::ScanLinks, orders::ScanEverything,
    orders::CancelScan, orders::FindMute, orders::ReadParameters, orders::WriteParameters, orders::StoreParameters,
    orders::RewriteSettings, orders::RestoreParameters, orders::UndoWrite, orders::KeepChange, orders::PutBackChange,
    orders::TakeSnapshot, orders::Identify, orders::Rename, orders::Renumber, orders::ClearFaults, orders::Calibrate,
    orders::SetDialect, orders::WishRates, orders::RenewMotion, orders::StopMotion, orders::ZeroPosition,
    orders::DismissStops, orders::PayGains, orders::DismissGains, orders::UpdateFirmware, orders::CancelOperation,
    orders::StartRecording, orders::StopRecording, orders::SteerReplay, orders::PauseService, orders::SkipUnit,
    orders::FinishService, orders::CancelService, orders::RenewService, orders::KeepJournal>;

/// Everything that the window may ask of the engine, as a value. Knows no Qt. A new order is a struct beside its like, a line in one
/// of the lists above, and its handler in app/.
using Order = decltype(detail::oneOf(MovingOrders(), StoppableOrders(), StillOrders()));

/// Which stops take back an order that was given before them and is not begun yet.
enum class TakenBackBy { EveryStop, StopOfTheUser, NoStop };
[[nodiscard]] constexpr TakenBackBy takenBackBy(const Order &order)
{
    return order.index() < MovingOrders::count                         ? TakenBackBy::EveryStop
        : order.index() < MovingOrders::count + StoppableOrders::count ? TakenBackBy::StopOfTheUser
                                                                       : TakenBackBy::NoStop;
}

/// What an order that went well is answered with: nothing for most, else what its struct names as its Answer.
using Answer = std::variant<std::monostate, DeviceId, tuning::Trial, tuning::TuneReport, tuning::FrequencyResponse>;

namespace detail {

template <class O> struct AnswerTo {
    using Type = void;
};
template <class O>
requires requires
{
    typename O::Answer;
}
struct AnswerTo<O> {
    using Type = typename O::Answer;
};

} // namespace detail

template <class O> using AnswerOf = typename detail::AnswerTo<O>::Type;

} // namespace mb
