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

#include <variant>

namespace mb {

/// Everything that the window may ask of the engine, as a value. Knows no Qt. A new order is a struct beside its like, a line here,
/// and its handler in app/.
using Order = std::variant<orders::OpenLink, orders::CloseLink, orders::ScanLinks, orders::ScanEverything,
    orders::CancelScan, orders::SendFrame, orders::ReadParameters, orders::WriteParameters, orders::StoreParameters,
    orders::RewriteSettings, orders::RestoreParameters, orders::UndoWrite, orders::KeepChange, orders::PutBackChange,
    orders::TakeSnapshot, orders::Identify, orders::Rename, orders::Renumber, orders::ClearFaults, orders::Calibrate,
    orders::SetDialect, orders::WishRates, orders::StartMotion, orders::UpdateMotion, orders::RenewMotion,
    orders::StopMotion, orders::ReleaseMoves, orders::ZeroPosition, orders::DismissStops, orders::RunExperiment,
    orders::RunTrial, orders::RunTuning, orders::RunSweep, orders::PayGains, orders::DismissGains,
    orders::UpdateFirmware, orders::CancelOperation, orders::StartRecording, orders::StopRecording, orders::SteerReplay,
    orders::ServeUnits, orders::PauseService, orders::SkipUnit, orders::RetryUnit, orders::RetryFailedUnits,
    orders::FinishService, orders::CancelService, orders::ArmService, orders::RenewService, orders::KeepJournal>;

/// What an order that went well is answered with: nothing for most, else what its struct names as its Answer.
using Answer = std::variant<std::monostate, tuning::Trial, tuning::TuneReport, tuning::FrequencyResponse>;

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
