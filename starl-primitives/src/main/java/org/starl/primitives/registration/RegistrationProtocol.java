package org.starl.primitives.registration;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import java.util.Set;
import java.util.SortedSet;
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
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.random.Rng;
import org.starl.trace.Instance;

/**
 * One robot's part in one registration: views 1, 2, 3, ... The Synod decides each view once, from a
 * proposal derived from the decided view before. A robot that wants a change proposes it; there is no
 * leader.
 *
 * <p>Its effects go to a {@link SynodLink} and a {@link RegistrationPort}.
 */
class RegistrationProtocol extends SynodProtocol {

  /** A leaving robot stays at most this long to spread the latest view, in ms. */
  static final long BROADCAST_MS = 5_000;

  /** The state of this robot's id. */
  enum Phase {
    OUT,
    JOINING,
    IN,
    LEAVING,
    /** Still listed, after an {@code unregister} that was given up. */
    LEFT_HALFWAY
  }

  private final RobotId self;
  private final List<RobotId> acceptors;
  private final RegistrationSettings settings;
  private final RegistrationPort port;
  private final StaleViewTimer staleView;
  private final ViewBroadcast broadcast = new ViewBroadcast(BROADCAST_MS * NS_PER_MS);
  private final PendingChanges pending;

  private Phase phase = Phase.OUT;
  private ProcessId me;
  private View view = View.NONE;

  // Asked for after each input; views are few, and equal numbers mean equal views.
  private RList.Agreed agreed = new RList.Agreed(Participants.of(), 0);
  private boolean failed;
  private boolean unregistered;
  private boolean hasTakenId;

  // The change that it works for.
  private Change current = Change.NONE;

  // Whether the latest view has no room for this robot, which wants to join.
  private boolean hasNoRoom;

  // The number of the latest proposal that would admit this robot; 0 for none.
  private long askedIn;

  private long deadlineNs = NEVER;
  private long queryAtNs = NEVER;
  private int nextQueried;

  // Others gave up the id of this robot: it need not unregister, and may register again.
  private boolean evicted;

  RegistrationProtocol(
      RobotId self,
      Participants acceptors,
      RegistrationSettings settings,
      Rng rng,
      SynodLink link,
      RegistrationPort port,
      long nowNs) {
    super(self, acceptors, port.freshProcess(), settings.timing(), rng, link, nowNs);
    this.self = self;
    this.acceptors = acceptors.asList();
    this.settings = settings;
    this.port = port;
    this.staleView = new StaleViewTimer(settings.nullMs() * NS_PER_MS, rng.fork("suspense"));
    this.pending = new PendingChanges(self, port);
    this.me = synod.proposerId();
    pending.addOwn(me);
    SynodMessage.Decided known = synod.latest();
    if (known != null) {
      learn(ViewFormat.read(known.number(), known.value()));
    }
  }

  // Calls.

  void do_register(long now) {
    nowNs = now;
    if (phase == Phase.LEAVING) {
      throw new IllegalStateException("do_register while it unregisters: wait for isUnregistered");
    }
    if (phase != Phase.OUT && phase != Phase.LEFT_HALFWAY) {
      return; // registered, or about to be
    }
    if (phase == Phase.LEFT_HALFWAY) {
      pending.markIdle(me);
    }
    failed = false;
    unregistered = false;
    evicted = false;
    phase = Phase.JOINING;
    deadlineNs = now + settings.deadlineMs() * NS_PER_MS;
    takeFreshId();
    change();
  }

  void unregister(long now) {
    nowNs = now;
    requireMayUnregister();
    if (unregistered) {
      return; // it was given up, and ended after all
    }
    if (phase != Phase.LEFT_HALFWAY) {
      port.acted(new RegistrationAction.unregister(me));
    }
    failed = false;
    if (evicted && !view.mentions(me)) {
      onUnregistered();
      return;
    }
    phase = Phase.LEAVING;
    deadlineNs = now + settings.deadlineMs() * NS_PER_MS;
    change();
  }

  void requireMayUnregister() {
    boolean isOut = phase == Phase.OUT && !evicted && !unregistered;
    if (isOut || phase == Phase.JOINING || phase == Phase.LEAVING) {
      throw new IllegalStateException("unregister while " + phase + ": register first");
    }
  }

  /** Proposes {@code confinement} until it is done or void. */
  void confine(Confinement confinement, long now) {
    nowNs = now;
    pending.confine(confinement);
    changeIfNew();
  }

  /** {@code id} of this robot will request nothing again, and holds nothing. */
  void markIdle(ProcessId id, long now) {
    nowNs = now;
    if (pending.markIdle(id)) {
      port.acted(new RegistrationAction.give_up(id));
    }
    if (id.equals(me) && phase == Phase.IN) {
      onEvicted();
    }
    changeIfNew();
  }

  /** The ids of this program's earlier starts are dead, and hold at most {@code sections}. */
  void standsIn(SortedSet<String> sections, long now) {
    nowNs = now;
    pending.standsIn(sections);
    // It may not know a view yet: it asks for one, and repeats that.
    synod.queryAll();
    queryAtNs = Math.min(queryAtNs, now + settings.queryMs() * NS_PER_MS);
    changeIfNew();
  }

  /** Asks all acceptors for the latest view. */
  void refresh(long now) {
    nowNs = now;
    synod.queryAll();
  }

  // Inputs.

  @Override
  protected void ownTimers() {
    if (nowNs >= deadlineNs) {
      giveUp();
    }
    broadcast.timer(nowNs);
    switch (staleView.timer(nowNs)) {
      case ASK -> synod.queryAll();
      case COMPLETE -> complete();
      case NOTHING -> {
        // Not due.
      }
    }
    if (nowNs >= queryAtNs) {
      synod.query(acceptors.get(nextQueried % acceptors.size()));
      nextQueried++;
      queryAtNs = nowNs + settings.queryMs() * NS_PER_MS;
    }
  }

  @Override
  protected long ownWakeAtNs() {
    long othersNs = Math.min(staleView.wakeAtNs(), broadcast.wakeAtNs());
    return Math.min(Math.min(deadlineNs, queryAtNs), othersNs);
  }

  // Queries.

  Phase phase() {
    return phase;
  }

  ProcessId me() {
    return me;
  }

  View view() {
    return view;
  }

  @Override
  public @Nullable Wait waitsFor(Instance source) {
    if (failed) {
      String why = hasNoRoom ? "the list has no room" : "no majority of the acceptors answered";
      return new Wait(source, "failed: " + why, List.of());
    }
    return hasNoRoom
        ? new Wait(source, "waits for room in the list", List.of())
        : super.waitsFor(source);
  }

  boolean hasFailed() {
    return failed;
  }

  boolean isUnregistered() {
    return unregistered && broadcast.isDone() && !pending.lingersIn(view);
  }

  RList rList() {
    if (phase != Phase.IN || !staleView.isListShown()) {
      return RList.UNKNOWN;
    }
    if (agreed.ts() != view.number()) {
      agreed = new RList.Agreed(view.participants(), view.number());
    }
    return agreed;
  }

  /** The state without times, the Synod's, and what is only shown: robots with equal texts behave alike. */
  String state() {
    String mine = phase + " " + me + hasTakenId + evicted + current + askedIn + view;
    return mine + (queryAtNs != NEVER) + nextQueried % acceptors.size() + staleView + pending;
  }

  // The protocol.

  /** Calls {@link #change} if the wanted change is new. */
  private void changeIfNew() {
    if (!wanted().equals(current)) {
      change();
    }
  }

  /** Proposes what this robot wants changed in the latest view, if anything. */
  private void change() {
    current = wanted();
    View base = view;
    ProcessId join = current.join();
    hasNoRoom = join != null && !new Proposal(base).add(current).view().contains(join);
    if (hasNoRoom) {
      // Others may have left: a robot that is not listed hears of newer views only if it asks.
      synod.queryAll();
      queryAtNs = Math.min(queryAtNs, nowNs + settings.queryMs() * NS_PER_MS);
    } else if (join != null) {
      askedIn = base.number() + 1;
    }
    Change wanted = hasNoRoom ? pending.in(base, null, null) : current;
    if (wanted.isVoidIn(view)) {
      synod.stop();
      return;
    }
    staleView.rumour(base.number() + 1, nowNs);
    synod.propose(
        base.number() + 1,
        wanted.toValue(),
        wishes -> ViewFormat.toValue(proposal(base, wanted, wishes)),
        nowNs);
  }

  /**
   * Completes a number that another robot proposed and that was not learned: its proposer may have gone
   * after the decision. If nothing was decided, the next view repeats this one.
   */
  private void complete() {
    if (phase == Phase.IN && !synod.isProposing()) {
      View same = view.next();
      synod.propose(
          same.number(), Change.NONE.toValue(), wishes -> ViewFormat.toValue(same), nowNs);
    }
  }

  /** The next view: always derived from the decided one. */
  View proposal(View decided, Change wanted, List<Value> wishes) {
    Proposal proposal = new Proposal(decided).add(wanted);
    for (Value wish : wishes) {
      proposal.add(Change.fromValue(wish));
    }
    return proposal.view();
  }

  private Change wanted() {
    return pending.in(view, phase == Phase.JOINING ? me : null, phase == Phase.LEAVING ? me : null);
  }

  private void learn(View learned) {
    long skippedFrom = askedIn;
    view = learned;
    boolean listed = learned.contains(me);
    if (phase == Phase.JOINING && listed) {
      settle(Phase.IN);
    } else if (phase == Phase.JOINING && skippedFrom > 0 && learned.number() > skippedFrom) {
      // A view that this robot never saw may have admitted it, and a later one may have removed it.
      pending.markIdle(me);
      port.acted(new RegistrationAction.give_up(me));
      takeFreshId();
    } else if ((phase == Phase.LEAVING || phase == Phase.LEFT_HALFWAY) && !learned.mentions(me)) {
      // Perhaps after the deadline: the app need not ask again.
      onUnregistered();
    } else if (phase == Phase.IN && !listed) {
      onEvicted();
    }
    staleView.learned(learned.number(), nowNs);
    change();
  }

  /** At the deadline. */
  private void giveUp() {
    boolean hadNoRoom = hasNoRoom;
    failed = true;
    if (phase == Phase.JOINING) {
      pending.markIdle(me);
      port.acted(new RegistrationAction.give_up(me));
      me = freshProcess();
      askedIn = 0;
      settle(Phase.OUT);
    } else {
      settle(Phase.LEFT_HALFWAY);
    }
    change();
    hasNoRoom = hadNoRoom; // why it failed
  }

  private void settle(Phase next) {
    phase = next;
    deadlineNs = NEVER;
    boolean asks = next != Phase.OUT || pending.hasOwnWord();
    queryAtNs = asks ? nowNs + settings.queryMs() * NS_PER_MS : NEVER;
  }

  /** Others gave this robot up. That is reported: a null list alone may also mean a newer one is coming. */
  private void onEvicted() {
    evicted = true;
    failed = true;
    settle(Phase.OUT);
  }

  private void onUnregistered() {
    settle(Phase.OUT);
    unregistered = true;
    evicted = false;
    failed = false;
  }

  // The proposer's id serves for the first registration, too.
  private void takeFreshId() {
    if (hasTakenId) {
      me = freshProcess();
    }
    hasTakenId = true;
    askedIn = 0;
    port.acted(new RegistrationAction.do_register(me));
  }

  private ProcessId freshProcess() {
    ProcessId id = port.freshProcess();
    pending.addOwn(id);
    return id;
  }

  @Override
  public void chosen(long number, Value value) {
    Set<RobotId> concerned = new TreeSet<>(acceptors);
    view.mentioned().forEach(id -> concerned.add(id.robot()));
    ViewFormat.read(number, value).mentioned().forEach(id -> concerned.add(id.robot()));
    concerned.remove(self);
    broadcast.begin(number, concerned.size(), nowNs);
    for (RobotId robot : concerned) {
      SynodMessage decided = new SynodMessage.Decided(number, value);
      port.sendReliably(robot, decided, () -> broadcast.settled(number));
    }
  }

  @Override
  public void learned(long number, Value value) {
    learn(ViewFormat.read(number, value));
  }

  @Override
  public void rumour(long number) {
    staleView.rumour(number, nowNs);
  }
}
