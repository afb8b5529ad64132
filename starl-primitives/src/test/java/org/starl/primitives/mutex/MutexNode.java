package org.starl.primitives.mutex;

import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.starl.ProcessId;
import org.starl.comms.LamportClock;

/** One participant under test, with what an all-seeing observer notes of it. */
final class MutexNode implements MutexProtocol.Effects {

  /** Makes the protocol under test: the real one, or a mutant. */
  @FunctionalInterface
  interface Kind {
    MutexProtocol make(
        ProcessId me, LamportClock clock, MutexTimes times, MutexProtocol.Effects effects);
  }

  static final MutexTimes TIMES = new MutexTimes(250, 1.5, 1_000, 1_000_000);

  final ProcessId id;
  final MutexProtocol protocol;
  final Consumer<MutexMessage> net;
  final Consumer<MutexEvent> trace;
  // The newest request, and which newest request of whom this one has consented to.
  long num;
  long ts;
  SortedSet<String> want = Sections.NONE;
  final TreeMap<ProcessId, Long> consentedTo = new TreeMap<>();
  boolean dead;

  MutexNode(ProcessId id, Kind kind, Consumer<MutexMessage> net, Consumer<MutexEvent> trace) {
    this.id = id;
    this.net = net;
    this.trace = trace;
    this.protocol = kind.make(id, new LamportClock(), TIMES, this);
  }

  boolean isIn(MutexProtocol.Phase phase) {
    return !dead && protocol.phase() == phase;
  }

  boolean isActive() {
    return !dead && protocol.phase() != MutexProtocol.Phase.IDLE;
  }

  @Override
  public void send(MutexMessage message) {
    net.accept(message);
  }

  @Override
  public void requested(
      long newNum, long newTs, SortedSet<String> newWant, SortedSet<ProcessId> known) {
    num = newNum;
    ts = newTs;
    want = newWant;
    trace.accept(new MutexEvent.DoMutex(id, num, ts, want, new TreeSet<>(known)));
  }

  @Override
  public void known(long ofNum, SortedSet<ProcessId> known) {
    trace.accept(new MutexEvent.Known(id, ofNum, new TreeSet<>(known)));
  }

  @Override
  public void granted(ProcessId to, long ofNum) {
    consentedTo.put(to, ofNum);
    trace.accept(new MutexEvent.Grant(id, to, ofNum));
  }

  @Override
  public void entered(long ofNum, SortedSet<String> held) {
    trace.accept(new MutexEvent.OdMutex(id, ofNum, held));
  }

  @Override
  public void released(long ofNum, SortedSet<String> given, SortedSet<String> left) {
    want = left;
    trace.accept(new MutexEvent.Release(id, ofNum, given, left));
  }

  @Override
  public void failed(long ofNum, MutexFailure why) {
    want = Sections.NONE;
    trace.accept(new MutexEvent.Withdraw(id, ofNum, why));
  }
}
