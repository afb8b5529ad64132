package org.starl.primitives.mutex;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.starl.comms.LamportClock;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.random.Rng;

/** One participant without a network and a clock, with the records of an observer that sees all. */
final class MutexNode implements MutexEffects {

  /** Creates the protocol: the real one, or a broken one in a test. */
  @FunctionalInterface
  interface Kind {
    MutexProtocol make(MutexProtocol.Self self, MutexEffects effects);
  }

  /**
   * The consents to one request.
   *
   * @param part the sections of a sequence; empty for all
   */
  record Consent(long num, SortedSet<String> part) {}

  static final MutexTimes TIMES = new MutexTimes(250, 1.5, 1_000, 1_000_000, 1_000_000, 1_000_000);

  final ProcessId id;
  final MutexProtocol protocol;
  final Consumer<MutexMessage> net;
  final Consumer<MutexFact> trace;
  // The newest request, and for each participant its newest request that this one has granted.
  long num;
  long ts;
  SortedSet<String> want = Sections.NONE;
  final TreeMap<ProcessId, Consent> consentedTo = new TreeMap<>();
  // The confinement that it proposes for the next view.
  final Set<Confinement> proposed = new LinkedHashSet<>();
  int refreshes;
  boolean isDone;
  boolean dead;
  SortedSet<String> bodyIn = Sections.NONE;

  MutexNode(ProcessId id, Kind kind, Consumer<MutexMessage> net, Consumer<MutexFact> trace) {
    this.id = id;
    this.net = net;
    this.trace = trace;
    this.protocol =
        kind.make(
            new MutexProtocol.Self(id, new LamportClock(), TIMES, new Rng(id.inc()), true), this);
  }

  /** The held sections; of a dead participant, those that its robot's next start has not denied. */
  SortedSet<String> held() {
    return Sections.common(protocol.held(), dead ? bodyIn : protocol.held());
  }

  void diesHolding() {
    dead = true;
    bodyIn = protocol.held();
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
      long newNum,
      long newTs,
      SortedSet<String> newWant,
      List<String> sequence,
      boolean resumes,
      SortedSet<ProcessId> known) {
    num = newNum;
    ts = newTs;
    want = newWant;
    trace.accept(new MutexFact.DoMutex(id, num, ts, want, sequence, resumes, new TreeSet<>(known)));
  }

  @Override
  public void known(long ofNum, SortedSet<ProcessId> known) {
    trace.accept(new MutexFact.Known(id, ofNum, new TreeSet<>(known)));
  }

  @Override
  public void granted(ProcessId to, long ofNum, SortedSet<String> part) {
    Consent before = consentedTo.get(to);
    SortedSet<String> all =
        before != null && before.num() == ofNum && !part.isEmpty()
            ? Sections.union(before.part(), part)
            : part;
    consentedTo.put(to, new Consent(ofNum, all));
    trace.accept(new MutexFact.Grant(id, to, ofNum, part));
  }

  @Override
  public void entered(long ofNum, SortedSet<String> held) {
    trace.accept(new MutexFact.OdMutex(id, ofNum, held));
  }

  @Override
  public void released(long ofNum, SortedSet<String> given, SortedSet<String> left) {
    want = Sections.without(want, given);
    trace.accept(new MutexFact.Release(id, ofNum, given, left));
  }

  @Override
  public void failed(long ofNum, MutexFailure why) {
    want = protocol.held();
    trace.accept(new MutexFact.Withdraw(id, ofNum, why));
  }

  @Override
  public void learned(View view) {
    trace.accept(new MutexFact.Learned(id, view));
  }

  @Override
  public void fenced(ProcessId suspect, SortedSet<String> open) {
    trace.accept(new MutexFact.Fence(id, suspect, open));
  }

  @Override
  public void propose(Confinement confinement) {
    proposed.add(confinement);
  }

  @Override
  public void refresh() {
    refreshes++; // The world delivers views at random times.
  }

  @Override
  public void markIdle() {
    isDone = true;
  }
}
