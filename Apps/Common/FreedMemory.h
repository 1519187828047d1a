// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What becomes of memory that a program has freed.
#ifndef stipple_FreedMemory_h
#define stipple_FreedMemory_h

namespace stipple
{
/// Has the GNU C library keep what is freed, for all threads alike, and the first gibibyte of it in
/// huge pages. A remesh allocates its arrays again and again, and the system clears every page that
/// it hands out: up to a quarter of the time where that is dear, as in virtual machines. The peak
/// is about the same (of 1.2 million triangles 6 % more); later at most 2 GiB are kept. Without
/// effect with another C library. Once in a program, before anything is done by several threads.
void keepFreedMemory();
}

#endif
