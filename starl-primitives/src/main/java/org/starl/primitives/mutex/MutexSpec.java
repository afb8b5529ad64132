package org.starl.primitives.mutex;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Liveness;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FaultState;
import org.starl.spec.FlagCheck;
import org.starl.spec.InstanceMonitor;
import org.starl.spec.Monitor;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

/**
 * The specification of every mutex in a run, or of the one that {@link #only} names, over its trace.
 *
 * <ul>
 *   <li>{@code Exclusive} (the paper's {@code Inv_mux_safety}): what participants of two robots
 *       hold is disjoint. A robot that crashed, left or closed its mutex without a release still
 *       holds its sections, since its body may be there, until the robot's next start declares
 *       otherwise.
 *   <li>{@code Exclusive} also holds of modes: two robots are in one section only in one mode, and
 *       not more than this has places: {@code Capacity} with {@link #withModes}, else a part of it.
 *   <li>{@code Promise}: of two participants with open, overlapping requests, one that has the
 *       other's consent comes first.
 *   <li>{@code Connected}: of two participants with open requests in the latest view, one needs the
 *       other's consent.
 *   <li>{@code Kept}: a removed participant holds only its fenced sections.
 *   <li>{@code Complete}: a participant that holds a section was on a list.
 *   <li>{@code crit}: the variable is true after an access, and after a release that leaves a
 *       section; it is false after a release of all.
 *   <li>{@code failed}: so do {@code failed} and {@code failure} after a request begins or ends without access.
 *   <li>{@code Served}, if there are bounds: a request has access, or has ended, within d2; owed
 *       while no participant has held for longer than d1.
 *   <li>{@code NonInterference}, if there are bounds: the same within d3; owed while no other
 *       participant holds, or waits with priority for, a section of the request. (The paper asks
 *       only that none is <em>held</em>. That is too weak: a participant that waits for {A, B}
 *       while another holds A delays a later request for B.)
 * </ul>
 *
 * <p>With bounds for a calm world the same two are also required there, within those: while no
 * fault has been active, and every robot has been up, for {@link FaultState#SETTLE_NS}; and there no live
 * participant is suspected: {@code Served} forbids the first fence of one. A request that ends at
 * its deadline before d2, or as occupied without a ghost, violates {@code Served} at any time. So does
 * one that waits for one cause only, longer than that may last: for a ghost, or for a dead participant
 * ({@link #confinedWithin}).
 *
 * <p>The last two are owed only while no fault but crashes is active, no ghost is fenced in a
 * wanted section, no participant is dead whose consent is needed, and the participant is not fenced
 * itself; {@code Served} only while
 * that holds for all waiting requests. They are owed again, with the whole bound, once it holds
 * again, and when the set of participants whose consent is needed changes. A participant that is
 * dead, has left the floor or was removed from the views is owed nothing.
 */
public final class MutexSpec extends InstanceMonitor<MutexRecord> {

  static final String EXCLUSIVE = "mutex.Exclusive";
  static final String CAPACITY = "mutex.Capacity";
  static final String PROMISE = "mutex.Promise";
  static final String CONNECTED = "mutex.Connected";

  static final String KEPT = "mutex.Kept";
  static final String COMPLETE = "mutex.Complete";
  static final String CRIT = "mutex.crit";
  static final String FAILED = "mutex.failed";

  private final @Nullable MutexBounds bounds;
  private final @Nullable MutexBounds calm;
  private final Liveness liveness = new Liveness();
  private final FlagCheck<Boolean> crit = new FlagCheck<>(MutexFact.CRIT, CRIT);
  private final FlagCheck<Boolean> failed = new FlagCheck<>(MutexFact.FAILED, FAILED);
  private final FlagCheck<MutexFailure> failure = new FlagCheck<>(MutexFact.FAILURE, FAILED);
  // The ids of each robot that hold something: more than one, if it has registered again meanwhile.
  private final Map<ProcessKey, Set<ProcessId>> holders = new LinkedHashMap<>();
  private String capacity = EXCLUSIVE;
  private Supplier<List<Monitor>> conformance =
      () -> List.of(new MutexConformance(), new ProtocolConformance());
  private long confinedNs = Deadlines.NO_BOUND;
  private boolean isAnswering;

  /** Safety only. */
  public MutexSpec() {
    this(null);
  }

  /** Safety, and progress within the bounds, if there are any. */
  public MutexSpec(@Nullable MutexBounds bounds) {
    this(bounds, null);
  }

  /**
   * Safety, and progress within the bounds.
   *
   * @param bounds with which lost messages are repeated; may be null
   * @param calm those of a calm world, in which none is lost; may be null
   */
  public MutexSpec(@Nullable MutexBounds bounds, @Nullable MutexBounds calm) {
    super(MutexFact.PRIMITIVE);
    this.bounds = bounds;
    this.calm = calm;
    lemma(EXCLUSIVE, "No two robots hold a section in common, unless in one mode.");
    lemma(
        PROMISE, "Of two overlapping requests, the one that has the other's consent comes first.");
    lemma(CONNECTED, "Of two requests by listed processes, one needs the other's consent.");
    lemma(KEPT, "A removed process holds only its fenced sections.");
    lemma(COMPLETE, "A process that holds a section was on the list.");
    lemma(CRIT, "The variable crit says whether the robot holds a section.");
    lemma(
        FAILED, "The variables failed and failure say whether and why the latest request failed.");
    if (bounds != null) {
      progress(
          MutexProgress.SERVED,
          "Every request is served within the bound, if no process holds sections for too long.");
      progress(
          MutexProgress.NON_INTERFERENCE,
          "A request without competing requests is served within its shorter bound.");
    }
  }

  /**
   * Requires, as part of {@code Served}, that a dead participant is confined within this time while a
   * request waits for it. Only for participants that register, if their robots are the acceptors.
   *
   * @param ns the time until suspicion, and more to decide the next view, in ns
   */
  public MutexSpec confinedWithin(long ns) {
    confinedNs = ns;
    return this;
  }

  /**
   * Also requires that a process which wants no section consents in the step in which it is asked, and that
   * a repeated request is answered in that step. Only of simulations: no time passes during their steps.
   */
  public MutexSpec answering() {
    isAnswering = true;
    return this;
  }

  /** Of mutexes with sequences, which are replayed on the theory of these, and on the protocol's. */
  public MutexSpec withSequences() {
    conformance = () -> List.of(new PipelineConformance(), new ProtocolConformance());
    return this;
  }

  /** Of mutexes with modes, which are replayed on the theory of these, sequences or not. */
  public MutexSpec withModes() {
    conformance = () -> List.of(new ModesConformance());
    capacity = CAPACITY;
    lemma(CAPACITY, "Not more robots hold a section in one mode than it has places.");
    return this;
  }

  @Override
  protected MutexRecord begin(Instance source) {
    return new MutexRecord(bounds, calm, liveness, capacity);
  }

  @Override
  public List<String> perRobotLemmas() {
    return List.of(KEPT, COMPLETE, CRIT, FAILED);
  }

  @Override
  public List<Monitor> companions() {
    // Bounds hold a lost message, its repetition, and the time after which a ghost's section is
    // given up, by the default times.
    long ghostNs =
        bounds == null
            ? Deadlines.NO_BOUND
            : bounds.d3Ns() + 2 * MutexTimes.DEFAULT.occupiedMs() * NS_PER_MS;
    ConsentSpec consents = new ConsentSpec(ghostNs, confinedNs);
    List<Monitor> companions = new ArrayList<>(conformance.get());
    companions.add(isAnswering ? consents.answering() : consents);
    return companions;
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    crit.observe(event, report);
    failed.observe(event, report);
    failure.observe(event, report);
    if (liveness.observe(event)) {
      instances().values().forEach(mutex -> mutex.livenessChanged(event.timeNs(), report));
    }
    super.observe(event, report);
  }

  @Override
  protected void acted(TraceEvent.Action action, Report report) {
    MutexRecord mutex = instance(action.source());
    if (action.fact() instanceof MutexFact fact) {
      mutex.expire(action.timeNs(), report);
      mutex.happened(fact, action.timeNs(), report);
      ProcessKey key = new ProcessKey(action.source(), action.robot());
      switch (fact) {
        case MutexFact.OdMutex access -> {
          holders.computeIfAbsent(key, robot -> new TreeSet<>()).add(access.who());
          crit.says(key, action, isTrue -> isTrue, report);
        }
        case MutexFact.Release release -> {
          Set<ProcessId> ids = holders.computeIfAbsent(key, robot -> new TreeSet<>());
          ids.removeIf(id ->
              id.boot() < release.who().boot()
                  || (id.equals(release.who()) && release.left().isEmpty()));
          boolean holds = !ids.isEmpty();
          crit.says(key, action, isTrue -> isTrue == holds, report);
        }
        case MutexFact.DoMutex request -> fails(key, action, MutexFailure.NONE, report);
        case MutexFact.Withdraw end -> fails(key, action, end.why(), report);
        default -> {}
      }
    }
  }

  private void fails(ProcessKey key, TraceEvent.Action action, MutexFailure why, Report report) {
    boolean hasFailed = why != MutexFailure.NONE;
    failed.says(key, action, is -> is == hasFailed, report);
    failure.says(key, action, is -> is == why, report);
  }

  @Override
  protected void changed(TraceEvent.Variable variable, Report report) {
    crit.shows(variable, report);
    ProcessKey key = new ProcessKey(variable.source(), variable.robot());
    if (Boolean.FALSE.equals(variable.of(MutexFact.FAILED))) { // a request begins: its fact follows
      failed.says(key, variable, any -> true, report);
      failure.says(key, variable, any -> true, report);
    }
    failed.shows(variable, report);
    failure.shows(variable, report);
  }

  @Override
  public void finish(long endNs, Report report) {
    instances().values().forEach(mutex -> mutex.expire(endNs, report));
  }
}
