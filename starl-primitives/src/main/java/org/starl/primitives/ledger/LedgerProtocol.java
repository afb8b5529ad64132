package org.starl.primitives.ledger;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.gvh.Wait;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodProtocol;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.ledger.LedgerMessage.Here;
import org.starl.primitives.ledger.LedgerMessage.Part;
import org.starl.primitives.suspicion.Suspicion;
import org.starl.random.Rng;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.trace.Instance;

/**
 * One robot's part in one ledger: a log of decrees 1, 2, 3, ..., each a list of {@link LedgerEntry}s. A
 * robot that wants changes proposes the next decree, with what others wish in it; there is no leader.
 *
 * <p>It takes decrees in order only: the Synod's acceptor forgets its vote for a decree when it learns
 * that decree, and by then the stored state has its effect.
 */
class LedgerProtocol extends SynodProtocol {

  /** The bytes of the entries of a decree, and of a wish; a promise has several wishes. */
  private static final int MAX_DECREE = 900;

  private static final int MAX_WISH = 250;
  private static final int PART = 900;

  /** For robots that are behind; one that is farther behind gets the state. */
  static final int KEPT_DECREES = 64;

  /** At most so many decrees answer one question. */
  private static final int BURST = 16;

  /** The shortest time between two questions for decrees. */
  private static final long ASK_NS = 200 * NS_PER_MS;

  /** A voter waits so much longer than the voter before it: it need not act if that one does. */
  private static final long TURN_NS = 500 * NS_PER_MS;

  /** A change that the app wants. */
  private record Wanted(LedgerEntry entry, LedgerCall call, long deadlineNs) {}

  private final ProcessId me;
  private final List<RobotId> voters;
  private final Participants group;
  private final LedgerSettings settings;
  private final SynodLink link;
  private final LedgerPort port;
  private final Suspicion suspicion;
  private final boolean isVoter;

  private LedgerState state;
  private final TreeMap<Long, Value> kept = new TreeMap<>();

  // Decrees that came before an earlier one.
  private final TreeMap<Long, Value> early = new TreeMap<>();

  private final List<Wanted> wanted = new ArrayList<>();
  private long beaconAtNs;
  private int beacons;
  private long askAtNs;

  // A state that is on its way, part by part.
  private long partsOf;
  private @Nullable Value[] parts = {};
  private long partsUntilNs;

  /**
   * @param me an id that no other program has
   * @param voters the same on every robot, for ever
   * @param group all robots that take part, voters or not
   */
  LedgerProtocol(
      ProcessId me,
      Participants voters,
      Participants group,
      LedgerSettings settings,
      Rng rng,
      SynodLink link,
      LedgerPort port,
      long nowNs) {
    super(me.robot(), voters, me, settings.timing(), rng, link, nowNs);
    this.me = me;
    this.voters = voters.asList();
    this.group = group;
    this.settings = settings;
    this.link = link;
    this.port = port;
    this.isVoter = voters.contains(me.robot());
    long rank = Math.max(0, this.voters.indexOf(me.robot()));
    this.suspicion = new Suspicion(settings.leaseMs() * NS_PER_MS + rank * TURN_NS);
    this.state = port.stored();
    this.beaconAtNs = nowNs;
    SynodMessage.Decided known = synod.latest();
    if (known != null && known.number() > state.number()) {
      throw new IllegalStateException(
          "the ledger's stored state is lost: it ends at decree "
              + (state.number() + ", but the acceptor's record at " + known.number()));
    }
    port.installed(state.number(), state.tasks().size());
    if (state.number() > 0) {
      synod.learn(state.number(), state.last());
    }
    watch();
    change();
  }

  // Calls.

  /** Works for a change until it is settled. */
  LedgerCall want(LedgerEntry entry, long now) {
    nowNs = now;
    LedgerCall call = new LedgerCall();
    wanted.add(new Wanted(entry, call, now + settings.deadlineMs() * NS_PER_MS));
    settle();
    change();
    return call;
  }

  // Inputs.

  @Override
  public void received(RobotId from, SynodMessage message, long now) {
    nowNs = now;
    if (message instanceof SynodMessage.Decided decree) {
      offer(decree.number(), decree.value());
    } else {
      super.received(from, message, now);
    }
    if (message.number() > state.number() + 1) {
      ask(from);
    }
  }

  void received(LedgerMessage message, long now) {
    nowNs = now;
    RobotId from = message.from().robot();
    switch (message) {
      case Here m -> {
        suspicion.heard(m.from(), now);
        if (m.number() > state.number()) {
          ask(from);
        } else if (m.asks() && m.number() < state.number()) {
          answer(from, m.number());
        }
      }
      case Part m -> collect(m);
    }
  }

  @Override
  protected void ownTimers() {
    if (nowNs >= beaconAtNs) {
      beacon();
    }
    settle();
    change();
  }

  @Override
  protected long ownWakeAtNs() {
    long wakeNs = Math.min(beaconAtNs, suspicion.wakeAtNs(nowNs));
    for (Wanted each : wanted) {
      wakeNs = Math.min(wakeNs, each.deadlineNs());
    }
    return wakeNs;
  }

  // Queries.

  ProcessId me() {
    return me;
  }

  LedgerState state() {
    return state;
  }

  /** Whether the log has this program's start: what it says of this robot is complete. */
  boolean isReady() {
    return me.equals(state.program(me.robot()));
  }

  /** Whether the robot has been silent for a lease, as far as this voter heard. */
  boolean isSilent(RobotId robot) {
    ProcessId program = state.program(robot);
    return program != null && suspicion.suspects(program, nowNs);
  }

  @Override
  public @Nullable Wait waitsFor(Instance source) {
    return wanted.isEmpty() && isReady() ? null : super.waitsFor(source);
  }

  // The log.

  /** Takes a decree, and those that waited for it. */
  private void offer(long number, Value value) {
    if (number > state.number() && number <= state.number() + KEPT_DECREES) {
      early.put(number, value);
    }
    takeInOrder();
  }

  private void takeInOrder() {
    early.headMap(state.number(), true).clear();
    Value next = early.remove(state.number() + 1);
    while (next != null) {
      long number = state.number() + 1;
      apply(number, next);
      synod.learn(number, next);
      next = early.remove(state.number() + 1);
    }
  }

  private void apply(long number, Value value) {
    state.next(number, value);
    List<LedgerEntry> effective = new ArrayList<>();
    for (LedgerEntry entry : read(value)) {
      if (state.apply(entry)) {
        effective.add(entry);
      }
    }
    kept.put(number, value);
    if (kept.size() > KEPT_DECREES) {
      kept.pollFirstEntry();
    }
    // Before the acceptor forgets its vote.
    port.store(state);
    port.applied(number, effective, state.tasks().size());
    watch();
    settle();
  }

  static List<LedgerEntry> read(Value value) {
    return value.length() == 0
        ? List.of()
        : value.read("the entries of a decree", LedgerEntry.LIST::read);
  }

  @Override
  public void chosen(long number, Value value) {
    for (RobotId robot : group) {
      if (!robot.equals(me.robot())) {
        link.send(robot, new SynodMessage.Decided(number, value));
      }
    }
    apply(number, value);
  }

  @Override
  public void learned(long number, Value value) {
    if (!early.containsKey(number + 1)) {
      change();
    }
  }

  // Changes.

  /** Proposes the next decree, if there is anything to change. */
  private void change() {
    if (synod.isProposing()) {
      return; // with what is wanted once it is free to choose
    }
    List<LedgerEntry> entries = proposals();
    if (!entries.isEmpty()) {
      synod.propose(
          state.number() + 1, fitting(entries, MAX_WISH), wishes -> decree(wishes), nowNs);
    }
  }

  private Value decree(List<Value> wishes) {
    Set<LedgerEntry> entries = new LinkedHashSet<>(proposals());
    for (Value wish : wishes) {
      for (LedgerEntry entry : read(wish)) {
        if (state.allows(entry)) {
          entries.add(entry);
        }
      }
    }
    return fitting(entries, MAX_DECREE);
  }

  /** The first of the entries that fit. */
  private static Value fitting(Iterable<LedgerEntry> entries, int bytes) {
    List<LedgerEntry> some = new ArrayList<>();
    int length = 0;
    for (LedgerEntry entry : entries) {
      length += WireWriter.toBytes(out -> LedgerEntry.SHAPE.write(entry, out)).length;
      if (length > bytes || some.size() == 0xFF) {
        break;
      }
      some.add(entry);
    }
    return Value.write(out -> LedgerEntry.LIST.write(some, out));
  }

  /** What this robot wants and the log allows. */
  private List<LedgerEntry> proposals() {
    if (!isReady()) {
      return List.of(new LedgerEntry.Start(me));
    }
    List<LedgerEntry> entries = new ArrayList<>();
    for (Wanted each : wanted) {
      if (state.allows(each.entry())) {
        entries.add(each.entry());
      }
    }
    for (LedgerTask<Value> task : state.tasks().values()) {
      ProcessId holder = task.holder();
      if (holder != null && !task.isBegun() && suspicion.suspects(holder, nowNs)) {
        entries.add(new LedgerEntry.Free(task.id(), task.claim()));
      }
    }
    return entries;
  }

  /** Tells the app what is settled. */
  private void settle() {
    for (Wanted each : new ArrayList<>(wanted)) {
      LedgerOutcome outcome = isReady() ? state.outcome(each.entry()) : LedgerOutcome.PENDING;
      if (outcome == LedgerOutcome.PENDING && nowNs >= each.deadlineNs()) {
        outcome = LedgerOutcome.UNKNOWN;
      }
      if (outcome != LedgerOutcome.PENDING) {
        wanted.remove(each);
        each.call().settle(outcome);
        port.told(each.entry(), outcome);
      }
    }
  }

  /** Voters watch the robots that hold tasks. */
  private void watch() {
    if (!isVoter) {
      return;
    }
    Set<ProcessId> holders = new TreeSet<>();
    for (LedgerTask<Value> task : state.tasks().values()) {
      ProcessId holder = task.holder();
      ProcessId program = holder == null ? null : state.program(holder.robot());
      if (program != null && !program.robot().equals(me.robot())) {
        holders.add(program);
      }
    }
    for (ProcessId watched : suspicion.expected()) {
      if (!holders.contains(watched)) {
        suspicion.release(watched);
      }
    }
    holders.forEach(holder -> suspicion.expect(holder, nowNs));
  }

  // Catching up.

  /** Tells all voters that it lives, and asks one of them for what it lacks. */
  private void beacon() {
    beaconAtNs = nowNs + settings.beaconMs() * NS_PER_MS;
    for (int i = 0; i < voters.size(); i++) {
      RobotId voter = voters.get(i);
      if (!voter.equals(me.robot())) {
        port.send(voter, new Here(me, state.number(), i == beacons % voters.size()));
      }
    }
    beacons++;
  }

  private void ask(RobotId robot) {
    if (nowNs >= askAtNs && !robot.equals(me.robot())) {
      askAtNs = nowNs + ASK_NS;
      port.send(robot, new Here(me, state.number(), true));
    }
  }

  /** Sends what a robot lacks that knows the decrees up to {@code number}. */
  private void answer(RobotId to, long number) {
    if (kept.containsKey(number + 1)) {
      for (Map.Entry<Long, Value> each : kept.tailMap(number + 1).entrySet()) {
        if (each.getKey() > number + BURST) {
          break;
        }
        link.send(to, new SynodMessage.Decided(each.getKey(), each.getValue()));
      }
      return;
    }
    byte[] all = WireWriter.toBytes(out -> LedgerState.SHAPE.write(state, out));
    int count = (all.length + PART - 1) / PART;
    for (int i = 0; i < count; i++) {
      byte[] bytes = Arrays.copyOfRange(all, i * PART, Math.min(all.length, (i + 1) * PART));
      port.sendReliably(to, new Part(me, state.number(), i, count, Value.of(bytes)));
    }
  }

  private void collect(Part part) {
    boolean isAwaited = nowNs < partsUntilNs; // else their sender may have crashed
    if (part.number() <= state.number() || (part.number() < partsOf && isAwaited)) {
      return;
    }
    if (part.number() != partsOf || part.count() != parts.length) {
      partsOf = part.number();
      parts = new Value[part.count()];
    }
    partsUntilNs = nowNs + settings.beaconMs() * NS_PER_MS;
    askAtNs = partsUntilNs;
    parts[part.index()] = part.bytes();
    WireWriter all = new WireWriter();
    for (Value each : parts) {
      if (each == null) {
        return;
      }
      all.raw(each.bytes());
    }
    parts = new Value[0];
    LedgerState newer;
    try {
      WireReader in = new WireReader(Arrays.copyOf(all.buffer(), all.length()));
      newer = LedgerState.SHAPE.read(in);
      in.expectEnd();
      newer.tasks().values().forEach(task -> port.check(task.what()));
    } catch (WireFormatException | IllegalArgumentException e) {
      port.refused(part.from(), "parts of a state: " + e.getMessage());
      return;
    }
    if (newer.number() == part.number()) {
      install(newer);
    } else {
      port.refused(part.from(), "a state after decree " + newer.number() + ": expected " + partsOf);
    }
  }

  private void install(LedgerState newer) {
    state = newer;
    kept.clear();
    port.store(state);
    port.installed(state.number(), state.tasks().size());
    watch();
    settle();
    synod.learn(state.number(), state.last());
    takeInOrder();
  }
}
