// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RankMessages.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkType.h"

#include <algorithm>

namespace stipple
{
namespace
{
constexpr int SizeTag = 40201;
constexpr int DataTag = 40202;
/// MPI counts with an int.
constexpr std::size_t LongestMessage = std::size_t(1) << 30;
}

RankMessages::RankMessages(vtkMultiProcessController* controller)
{
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    this->Controller = controller;
    this->Rank = controller->GetLocalProcessId();
    this->Size = controller->GetNumberOfProcesses();
  }
}

void RankMessages::sum(std::vector<long long>& values) const
{
  if (this->Controller && !values.empty())
  {
    const std::vector<long long> own = values;
    this->Controller->AllReduce(
      own.data(), values.data(), static_cast<vtkIdType>(values.size()), vtkCommunicator::SUM_OP);
    this->Sent += static_cast<double>(values.size() * sizeof(values[0]));
  }
}

void RankMessages::minimum(std::vector<double>& values) const
{
  if (this->Controller && !values.empty())
  {
    const std::vector<double> own = values;
    this->Controller->AllReduce(
      own.data(), values.data(), static_cast<vtkIdType>(values.size()), vtkCommunicator::MIN_OP);
    this->Sent += static_cast<double>(values.size() * sizeof(values[0]));
  }
}

std::vector<Bytes> RankMessages::gather(const Bytes& own) const
{
  return this->exchange(std::vector<Bytes>(static_cast<std::size_t>(this->Size), own));
}

std::vector<Bytes> RankMessages::exchange(std::vector<Bytes> bytes) const
{
  std::vector<Bytes> received(static_cast<std::size_t>(this->Size));
  received[this->Rank] = std::move(bytes[this->Rank]);
  const auto send = [&](int to) {
    const auto size = static_cast<long long>(bytes[to].size());
    this->Controller->Send(&size, 1, to, SizeTag);
    for (std::size_t at = 0; at < bytes[to].size(); at += LongestMessage)
    {
      const std::size_t length = std::min(LongestMessage, bytes[to].size() - at);
      this->Controller->Send(bytes[to].data() + at, static_cast<vtkIdType>(length), to, DataTag);
    }
    this->Sent += static_cast<double>(bytes[to].size());
    bytes[to] = Bytes();
  };
  const auto receive = [&](int from) {
    long long size = 0;
    this->Controller->Receive(&size, 1, from, SizeTag);
    received[from].resize(static_cast<std::size_t>(size));
    for (std::size_t at = 0; at < received[from].size(); at += LongestMessage)
    {
      const std::size_t length = std::min(LongestMessage, received[from].size() - at);
      this->Controller->Receive(
        received[from].data() + at, static_cast<vtkIdType>(length), from, DataTag);
    }
  };
  // Rounds of a tournament: in each, ranks pair off, and of a pair the lower one sends first, so
  // that no two wait for each other.
  for (int round = 0; round < this->Size; ++round)
  {
    const int partner = ((round - this->Rank) % this->Size + this->Size) % this->Size;
    if (partner == this->Rank)
    {
      continue;
    }
    if (this->Rank < partner)
    {
      send(partner);
      receive(partner);
    }
    else
    {
      receive(partner);
      send(partner);
    }
  }
  return received;
}

Status RankMessages::agree(const Status& own) const
{
  if (!this->Controller)
  {
    return own;
  }
  Bytes message;
  if (!own.ok())
  {
    const auto code = static_cast<unsigned long>(own.code());
    message.resize(sizeof code);
    std::memcpy(message.data(), &code, sizeof code);
    message.insert(message.end(), own.message().begin(), own.message().end());
  }
  for (const Bytes& said : this->gather(message))
  {
    if (!said.empty())
    {
      unsigned long code = 0;
      std::memcpy(&code, said.data(), sizeof code);
      const std::string sentence(said.begin() + sizeof code, said.end());
      switch (static_cast<StatusCode>(code))
      {
        case StatusCode::Aborted:
          return Status::aborted();
        case StatusCode::BadInput:
          return Status::error(sentence);
        case StatusCode::TooFewPoints:
          return Status::tooFewPoints(sentence);
        default:
          return Status::internal(sentence);
      }
    }
  }
  return Status::success();
}
}
