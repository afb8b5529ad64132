// Longer than 500 lines because an app has one object for sets and sequences, over all ids of its
// robot.
package org.starl.primitives.mutex;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.gvh.Wait;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.platform.Waits;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Membership;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexProtocol.Phase;
import org.starl.primitives.mutex.MutexProtocol.Resume;
import org.starl.primitives.mutex.MutexProtocol.Self;
import org.starl.random.Rng;
import org.starl.time.Time;
import org.starl.trace.Instance;

/**
 * The mutex of one robot: connects {@link MutexProtocol} to its gvh. Create it at the start of the
 * app, before {@code do_register}, so that it answers for every id of this robot. Strand only.
 *
 * <p>Each registration gives the robot a new id, and each id is a separate participant. An older id
 * sends no requests, and grants all requests. If it still holds sections, it defers requests for
 * them, and the robot cannot request until it has released them; but the rest of a sequence, with these
 * sections, may be requested at once.
 */
public final class M_Mutex implements PipelinePrim {

  /** Pause after a failed request. */
  private static final long RETRY_MS = 500;

  private final GlobalVarHolder gvh;
  private final Membership membership;
  private final MutexTimes times;
  private final Rng rng;
  private final Instance source;
  private final Endpoint<MutexMessage> endpoint;
  private final Timer timer;
  private final GvhCell<Boolean> crit;
  private final GvhCell<Boolean> failed;
  private final GvhCell<MutexFailure> failure;

  private MutexProtocol current;
  private @Nullable MutexProtocol lingering;
  private Resume resume = Resume.NOTHING;
  // What the earlier processes keep of it: also the way ahead. Another robot that got this, and
  // waits for the body, would be in the way.
  private SortedSet<String> kept = Sections.NONE;
  // Older ids, permanently idle, each with the participants that it has fenced.
  private final Map<ProcessId, Set<ProcessId>> retired = new TreeMap<>();
  // Calls to the membership, which may call back: they run after the protocol's step.
  private final Queue<Runnable> membershipCalls = new ArrayDeque<>();

  /** When this robot learned of each ghost. */
  private final Map<ProcessId, Long> ghostsNs = new TreeMap<>();

  private boolean closed;

  /**
   * Creates a mutex among the robots of this robot's registration {@code xid} (paper, Figure 4).
   *
   * @throws IllegalStateException if the robot's program has created no registration {@code xid}
   */
  public M_Mutex(GlobalVarHolder gvh, String xid) {
    this(gvh, xid, registration(gvh, xid));
  }

  /**
   * Creates a mutex among a fixed group (the paper's {@code Mutex(id, PList)}). A robot whose
   * program has restarted cannot take part: it is a new participant, and the earlier one may still
   * hold sections.
   *
   * @param participants the same on every robot
   */
  public M_Mutex(GlobalVarHolder gvh, String xid, Participants participants) {
    this(gvh, xid, closedGroup(gvh, participants));
  }

  /** Creates a mutex among the registered robots. */
  public M_Mutex(GlobalVarHolder gvh, String xid, Membership membership) {
    this(gvh, xid, membership, MutexTimes.DEFAULT);
  }

  /**
   * Creates a mutex among the registered robots.
   *
   * @throws IllegalStateException if the robot's program has already created this instance
   */
  public M_Mutex(GlobalVarHolder gvh, String xid, Membership membership, MutexTimes times) {
    this.gvh = gvh;
    this.membership = membership;
    this.times = times;
    Channel<MutexMessage> channel = new Channel<>(MutexFact.PRIMITIVE, xid, MutexMessage.SHAPE);
    source = channel.instance();
    gvh.requireFirstInstance(source);
    crit = gvh.variable(source, MutexFact.CRIT, false);
    failed = gvh.variable(source, MutexFact.FAILED, false);
    failure = gvh.variable(source, MutexFact.FAILURE, MutexFailure.NONE);
    timer = gvh.plat.timers.timer(this::timerExpired);
    rng = gvh.plat.entropy.fork(source.name());
    membership.join(this::leave);
    current = participant(membership.me());
    follow();
    endpoint = gvh.comms.open(channel, this::received);
    membership.onChange(this::membershipChanged);
    gvh.explain(this::waitsFor);
  }

  private static Membership registration(GlobalVarHolder gvh, String xid) {
    Membership registration = gvh.published(Membership.class, xid);
    if (registration == null) {
      throw new IllegalStateException(
          MutexFact.source(xid)
              + ": this robot has no registration/"
              + xid
              + ": expected one, created before, or a list of participants");
    }
    return registration;
  }

  /** The closed group of the participants of each robot's first start. */
  public static Membership closedGroup(GlobalVarHolder gvh, Participants participants) {
    return Membership.closed(
        ProcessId.first(gvh.id.name(), gvh.id.boot()), View.closed(participants));
  }

  @Override
  public void do_mutex(Collection<String> sections) {
    requireOpen();
    SortedSet<String> want = inOneMode("do_mutex", sections);
    if (lingering != null) {
      throw new IllegalStateException(
          source + ": do_mutex of " + want + " while holding " + lingering.held());
    }
    if (current.phase() == Phase.IDLE && !want.isEmpty()) {
      failed.set(false);
      failure.set(MutexFailure.NONE);
    }
    current.request(want, gvh.plat.clock.nowNs());
    settle();
  }

  @Override
  public MutexFailure acquire(Collection<String> sections, long timeoutMs) {
    return acquiring(sections, timeoutMs).block(gvh.plat.strand);
  }

  @Override
  public Waits<MutexFailure> acquiring(Collection<String> sections, long timeoutMs) {
    return new Waits<>(call ->
        acquire(
            call,
            sections,
            Time.afterMs(gvh.plat.clock.nowNs(), timeoutMs),
            MutexFailure.WITHDRAWN));
  }

  private void acquire(
      Waits<MutexFailure> call, Collection<String> sections, long untilNs, MutexFailure soFar) {
    do_mutex(sections);
    call.until(
        () -> crit.get() || failed.get(),
        untilNs,
        held -> {
          if (crit.get()) {
            call.end(MutexFailure.NONE);
          } else if (failed.get()) {
            retry(call, sections, untilNs, failure.get());
          } else {
            withdraw();
            retry(call, sections, untilNs, soFar);
          }
        });
  }

  private void retry(
      Waits<MutexFailure> call, Collection<String> sections, long untilNs, MutexFailure why) {
    long nowNs = gvh.plat.clock.nowNs();
    long leftNs = untilNs - nowNs;
    if (leftNs <= RETRY_MS * NS_PER_MS) {
      call.end(why);
      return;
    }
    call.until(
        null,
        Time.afterMs(nowNs, RETRY_MS),
        slept ->
            membership.register(
                call,
                leftNs / NS_PER_MS - RETRY_MS,
                mayRequest -> {
                  if (mayRequest) {
                    acquire(call, sections, untilNs, why);
                  } else {
                    call.end(MutexFailure.NOT_REGISTERED);
                  }
                }));
  }

  @Override
  public List<Occupant> occupants() {
    List<Occupant> occupants = new ArrayList<>();
    membership
        .view()
        .ghosts()
        .forEach((id, ghost) ->
            occupants.add(
                new Occupant(id.robot(), ghost.sections(), ghostsNs.getOrDefault(id, 0L))));
    return occupants;
  }

  @Override
  public void doSequence(List<String> sections) {
    requireOpen();
    if (inOneMode("doSequence", sections).size() < sections.size()) {
      throw new IllegalArgumentException(source + ": doSequence of " + sections + ": one twice");
    }
    if (!sections.containsAll(holder().held())) {
      throw new IllegalArgumentException(
          source + ": doSequence of " + sections + " while holding " + holder().held());
    }
    if (current.phase() == Phase.IDLE && !sections.isEmpty()) {
      failed.set(false);
      failure.set(MutexFailure.NONE);
    }
    current.request(List.copyOf(sections), true, gvh.plat.clock.nowNs());
    settle();
  }

  /** A robot in two modes of a section could wait for another one that is in both, too. */
  private SortedSet<String> inOneMode(String call, Collection<String> sections) {
    SortedSet<String> want = Sections.copyOf(sections);
    Set<String> places = new TreeSet<>();
    for (String section : want) {
      if (!places.add(Sections.place(section))) {
        throw new IllegalArgumentException(
            String.format(
                "%s: %s of %s: expected one mode of %s",
                source, call, want, Sections.place(section)));
      }
    }
    return want;
  }

  @Override
  public void resume(Collection<String> stands, List<String> sections) {
    if (!sections.containsAll(stands)) {
      throw new IllegalArgumentException(
          source + ": resume in " + stands + " with " + sections + ": expected all of the first");
    }
    resume =
        stands.isEmpty()
            ? Resume.NOTHING
            : new Resume(Sections.copyOf(stands), Sections.copyOf(sections));
    current.takeOver(resume);
    kept = resume.claims();
    standsIn(kept);
  }

  @Override
  public int contenders(String... sections) {
    return current.contenders(Arrays.asList(sections));
  }

  @Override
  public void do_mutex(Collection<String> sections, Participants plist) {
    RobotId me = current.me().robot();
    if (!plist.contains(me)) {
      throw new IllegalArgumentException(
          source + ": do_mutex among " + plist + ": expected " + me + " among them");
    }
    for (RobotId robot : plist) {
      if (!current.excludes(robot)) {
        throw new IllegalArgumentException(
            String.format(
                "%s: do_mutex cannot exclude %s, which is not in the group %s",
                source, robot, membership.view().participants()));
      }
    }
    do_mutex(sections);
  }

  @Override
  public GvhVariable<Boolean> crit() {
    return crit.variable();
  }

  @Override
  public GvhVariable<Boolean> failed() {
    return failed.variable();
  }

  @Override
  public GvhVariable<MutexFailure> failure() {
    return failure.variable();
  }

  @Override
  public void release(Collection<String> sections) {
    requireOpen();
    SortedSet<String> given = Sections.copyOf(sections);
    SortedSet<String> stands = current.stands();
    if (given.isEmpty() || !Sections.union(held(), stands).containsAll(given)) {
      throw new IllegalArgumentException(
          source + ": release of " + given + " while holding " + held());
    }
    current.leave(Sections.common(stands, given));
    release(lingering, given);
    release(current, given);
    settle();
  }

  private void release(@Nullable MutexProtocol holder, SortedSet<String> given) {
    if (holder != null && Sections.meet(holder.held(), given)) {
      holder.release(Sections.common(holder.held(), given));
    }
    if (lingering != null && lingering.phase() == Phase.IDLE) {
      retire(lingering);
      lingering = null;
    }
    tellHeld();
    if (!resume.isOver() && holder == current) {
      resume = current.resume();
    }
  }

  /** What an older id holds passes to the current one, when this has access to all of it. */
  private void takeOver() {
    if (lingering != null && current.held().containsAll(lingering.held())) {
      release(lingering, lingering.held());
    }
  }

  @Override
  public void withdraw() {
    requireOpen();
    current.withdraw(MutexFailure.WITHDRAWN);
    settle();
  }

  @Override
  public void standsIn(Collection<String> sections) {
    requireOpen();
    SortedSet<String> checked = Sections.copyOf(sections);
    gvh.trace.action(source, MutexFact.SHAPE, new MutexFact.StandsIn(membership.me(), checked));
    membership.standsIn(checked);
  }

  @Override
  public SortedSet<String> held() {
    return lingering == null ? current.held() : Sections.union(lingering.held(), current.held());
  }

  @Override
  public Instance source() {
    return source;
  }

  @Override
  public void close() {
    if (!closed) {
      withdraw();
      closed = true;
      timer.cancel();
      endpoint.close();
    }
  }

  private @Nullable Wait waitsFor() {
    SortedSet<String> held = held();
    String holds = held.isEmpty() ? "" : "holds " + held;
    if (closed || current.phase() != Phase.TRYING) {
      String state = held.isEmpty() && failed.get() ? "failed: " + failureText() : holds;
      return closed || state.isEmpty() ? null : new Wait(source, state, List.of());
    }
    SortedSet<ProcessId> missing = current.missing();
    String waits =
        "requests "
            + current.wanted()
            + (missing.isEmpty() ? "; a removed process may still be inside" : "; answers missing");
    return new Wait(
        source, holds.isEmpty() ? waits : holds + ", " + waits, ProcessId.robots(missing));
  }

  private String failureText() {
    boolean isOccupied = failure.get() == MutexFailure.OCCUPIED;
    return isOccupied ? failure.get() + " by " + occupants() : failure.get().toString();
  }

  private MutexProtocol holder() {
    return lingering == null ? current : lingering;
  }

  private MutexProtocol participant(ProcessId me) {
    Rng its = rng.fork(me.toString());
    return new MutexProtocol(
        new Self(me, gvh.comms.lamportClock(), times, its, membership.confines(), resume),
        new Wiring(me));
  }

  private void retire(MutexProtocol participant) {
    retired.put(participant.me(), participant.fenced());
  }

  private void membershipChanged() {
    if (closed) {
      return;
    }
    if (!membership.me().equals(current.me())) {
      resume = current.rest().isOver() ? resume : current.rest();
      current.withdraw(MutexFailure.REMOVED);
      if (current.phase() == Phase.IDLE) {
        retire(current);
      } else {
        lingering = current;
      }
      current = participant(membership.me());
    }
    follow();
    tellHeld();
    settle();
  }

  /**
   * Its robot knows best what an older id holds: the others may have been told too little of it to fence
   * it in less than it asked for.
   */
  private void tellHeld() {
    View.Ghost ghost = lingering == null ? null : membership.view().ghost(lingering.me());
    if (ghost != null && lingering != null && !lingering.held().containsAll(ghost.sections())) {
      membership.propose(
          new Confinement(lingering.me(), lingering.held(), Collections.emptySortedSet()));
    }
  }

  /** Updates the current participant from the membership. */
  private void follow() {
    ghostsNs.keySet().retainAll(membership.view().ghosts().keySet());
    for (ProcessId ghost : membership.view().ghosts().keySet()) {
      ghostsNs.putIfAbsent(ghost, gvh.plat.clock.nowNs());
    }
    current.learn(membership.view());
    if (current.mayRequest() && !membership.mayRequest()) {
      leave();
    }
  }

  /** Prepares for the robot's unregistration. */
  private void leave() {
    if (closed) {
      return;
    }
    if (!held().isEmpty()) {
      throw new IllegalStateException(
          source + ": unregister while holding " + held() + ": release it first");
    }
    current.withdraw(MutexFailure.REMOVED);
    current.beginLeave();
  }

  private void received(RobotId from, MutexMessage message) {
    if (!message.from().robot().equals(from)) {
      return; // forged: the sender is another robot
    }
    long nowNs = gvh.plat.clock.nowNs();
    if (message.to().equals(current.me())) {
      current.receive(message, nowNs);
      settle();
    } else if (lingering != null && message.to().equals(lingering.me())) {
      lingering.receive(message, nowNs);
      settle();
    } else if (message instanceof MutexMessage.Req req) {
      answerAsRetired(req);
    }
  }

  // A retired id is permanently idle, so it grants every request, except those of fenced ones.
  private void answerAsRetired(MutexMessage.Req req) {
    Set<ProcessId> fenced = retired.get(req.to());
    if (fenced != null && !fenced.contains(req.from())) {
      endpoint.send(req.from().robot(), new MutexMessage.Ok(req.to(), req.from(), req.num()));
    }
  }

  private void timerExpired() {
    current.timer(gvh.plat.clock.nowNs());
    settle();
  }

  /** Calls the membership, as a step of the protocol requires. */
  private void settle() {
    if (!kept.isEmpty() && !current.kept().containsAll(kept)) {
      kept = Sections.common(kept, current.kept());
      standsIn(kept);
    }
    while (!membershipCalls.isEmpty()) {
      membershipCalls.remove().run();
    }
    timer.set(current.nextTimerNs());
  }

  private void requireOpen() {
    if (closed) {
      throw new IllegalStateException(source + " is closed");
    }
  }

  /** Performs and traces the effects of one participant. */
  private final class Wiring implements MutexEffects {
    private final ProcessId me;

    Wiring(ProcessId me) {
      this.me = me;
    }

    @Override
    public void send(MutexMessage message) {
      endpoint.send(message.to().robot(), message);
    }

    @Override
    public void requested(
        long num,
        long ts,
        SortedSet<String> want,
        List<String> sequence,
        boolean resumes,
        SortedSet<ProcessId> known) {
      trace(() -> new MutexFact.DoMutex(me, num, ts, want, sequence, resumes, copy(known)));
    }

    @Override
    public void known(long num, SortedSet<ProcessId> known) {
      trace(() -> new MutexFact.Known(me, num, copy(known)));
    }

    @Override
    public void granted(ProcessId to, long num, SortedSet<String> part) {
      trace(() -> new MutexFact.Grant(me, to, num, part));
    }

    @Override
    public void entered(long num, SortedSet<String> held) {
      trace(() -> new MutexFact.OdMutex(me, num, held));
      crit.set(true);
      membershipCalls.add(M_Mutex.this::takeOver);
    }

    @Override
    public void released(long num, SortedSet<String> given, SortedSet<String> left) {
      trace(() -> new MutexFact.Release(me, num, given, left));
      crit.set(!held().isEmpty());
    }

    @Override
    public void failed(long num, MutexFailure why) {
      trace(() -> new MutexFact.Withdraw(me, num, why));
      failed.set(true);
      failure.set(why);
    }

    @Override
    public void learned(View view) {
      trace(() -> new MutexFact.Learned(me, view));
    }

    @Override
    public void fenced(ProcessId suspect, SortedSet<String> open) {
      gvh.log.w(source.name(), "fences " + suspect + ", which seems to have crashed");
      trace(() -> new MutexFact.Fence(me, suspect, open));
    }

    @Override
    public void propose(Confinement confinement) {
      membershipCalls.add(() -> membership.propose(confinement));
    }

    @Override
    public void refresh() {
      membershipCalls.add(membership::refresh);
    }

    @Override
    public void markIdle() {
      membershipCalls.add(() -> membership.markIdle(me));
    }

    private void trace(Supplier<MutexFact> event) {
      if (gvh.trace.isOn()) {
        gvh.trace.action(source, MutexFact.SHAPE, event.get());
      }
    }

    private static SortedSet<ProcessId> copy(SortedSet<ProcessId> ids) {
      return Collections.unmodifiableSortedSet(new TreeSet<>(ids));
    }
  }
}
