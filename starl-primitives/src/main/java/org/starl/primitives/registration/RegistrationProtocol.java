package org.starl.primitives.registration;

import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Synod;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodListener;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodProtocol;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.random.Rng;

/**
 * One robot's part in one registration: views 1, 2, 3, ... each decided by the Synod, each derived
 * from the decided one before. Who wants a change proposes it; there is no leader.
 *
 * <p>Calls, messages and timers in, effects out through a {@link SynodLink} and a {@link RegistrationPort}.
 */
class RegistrationProtocol implements SynodProtocol {

  private static final long NS_PER_MS = 1_000_000;

  /** Who leaves stays at most so long for others' sake. */
  private static final long NEWS_MS = 5_000;

  /** Where this robot's id stands. */
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
  private final Synod synod;
  private final Suspense suspense;
  private final News news = new News(NEWS_MS * NS_PER_MS);

  private Phase phase = Phase.OUT;
  private ProcessId me;
  private View view = View.NONE;
  private boolean failed;
  private boolean unregistered;

  private Change worksFor = Change.NONE;

  // The number of the latest proposal that would let me in; 0 for none.
  private long askedIn;

  private long deadlineNs = Long.MAX_VALUE;
  private long queryAtNs = Long.MAX_VALUE;
  private int nextQueried;
  private long nowNs;

  private final Wants wants;

  // Whether others gave up who I was: I need not unregister, and may register anew.
  private boolean wasPutOut;

  /**
   * @param isFirstStart whether this robot starts for the first time, and so is who the initial view
   *     says it is
   */
  RegistrationProtocol(
      RobotId self,
      Participants acceptors,
      RegistrationSettings settings,
      Rng rng,
      SynodLink link,
      boolean isFirstStart,
      RegistrationPort port,
      long nowNs) {
    this.nowNs = nowNs;
    this.self = self;
    this.acceptors = acceptors.asList();
    this.settings = settings;
    this.port = port;
    this.suspense = new Suspense(settings.nullMs() * NS_PER_MS, rng.fork("suspense"));
    this.wants = new Wants(self, port);
    this.me = freshProcess();
    this.synod = new Synod(self, acceptors, me, settings.timing(), rng, link, new Decrees());
    start(isFirstStart);
  }

  private void start(boolean isFirstStart) {
    View initial = settings.initialView();
    if (initial.number() > 0) {
      port.isGiven(initial);
    }
    for (ProcessId id : initial.ids()) {
      if (isFirstStart && id.robot().equals(self)) {
        me = id;
        wants.isMine(id);
        settle(Phase.IN);
      }
    }
    SynodMessage.Decided known = synod.latest();
    if (known != null) {
      learn(ViewFormat.read(known.number(), known.value()));
    }
    if (initial.number() > view.number()) {
      synod.learn(initial.number(), ViewFormat.toValue(initial));
    }
  }

  // Calls.

  void do_register(long now) {
    nowNs = now;
    if (phase != Phase.OUT && phase != Phase.LEFT_HALFWAY) {
      throw new IllegalStateException("do_register while " + phase + ": unregister first");
    }
    if (phase == Phase.LEFT_HALFWAY) {
      wants.isIdle(me);
    }
    failed = false;
    unregistered = false;
    wasPutOut = false;
    phase = Phase.JOINING;
    deadlineNs = now + settings.deadlineMs() * NS_PER_MS;
    takeFreshId();
    change();
  }

  void unregister(long now) {
    nowNs = now;
    requireMayUnregister();
    if (phase != Phase.LEFT_HALFWAY) {
      port.unregisters(me);
    }
    failed = false;
    if (wasPutOut && !view.mentions(me)) {
      isOut();
      return;
    }
    phase = Phase.LEAVING;
    deadlineNs = now + settings.deadlineMs() * NS_PER_MS;
    change();
  }

  void requireMayUnregister() {
    boolean isOut = phase == Phase.OUT && !wasPutOut;
    if (isOut || phase == Phase.JOINING || phase == Phase.LEAVING) {
      throw new IllegalStateException("unregister while " + phase + ": register first");
    }
  }

  /** Works for {@code confinement} until it is done or void. */
  void confine(Confinement confinement, long now) {
    nowNs = now;
    wants.confine(confinement);
    changeIfNew();
  }

  /** An id of mine requests nothing any more, and holds nothing. */
  void isIdleForEver(ProcessId id, long now) {
    nowNs = now;
    if (wants.isIdle(id)) {
      port.givesUp(id);
    }
    if (id.equals(me) && phase == Phase.IN) {
      isPutOut();
    }
    changeIfNew();
  }

  /** The ids of earlier starts of this program are dead, and no body of theirs is elsewhere. */
  void standsIn(SortedSet<String> sections, long now) {
    nowNs = now;
    wants.standsIn(sections);
    // It may not even know a list: it asks for one, and goes on asking.
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
  public void received(RobotId from, SynodMessage message, long now) {
    nowNs = now;
    synod.received(from, message, now);
  }

  @Override
  public void flushed(long version, long now) {
    nowNs = now;
    synod.flushed(version);
  }

  @Override
  public void timer(long now) {
    nowNs = now;
    synod.timer(now);
    if (now >= deadlineNs) {
      giveUp();
    }
    news.timer(now);
    switch (suspense.timer(now)) {
      case ASK -> synod.queryAll();
      case COMPLETE -> complete();
      case NOTHING -> {
        // Not due.
      }
    }
    if (now >= queryAtNs) {
      synod.query(acceptors.get(nextQueried % acceptors.size()));
      nextQueried++;
      queryAtNs = now + settings.queryMs() * NS_PER_MS;
    }
  }

  @Override
  public long wakeAtNs() {
    long ownNs = Math.min(deadlineNs, queryAtNs);
    long othersNs = Math.min(suspense.wakeAtNs(), news.wakeAtNs());
    return Math.min(synod.wakeAtNs(), Math.min(ownNs, othersNs));
  }

  // What is known.

  Phase phase() {
    return phase;
  }

  ProcessId me() {
    return me;
  }

  View view() {
    return view;
  }

  boolean hasFailed() {
    return failed;
  }

  boolean isUnregistered() {
    return unregistered && news.isOut() && !wants.lingersIn(view);
  }

  RList rList() {
    return phase == Phase.IN && suspense.isListShown()
        ? new RList.Agreed(view.participants(), view.number())
        : RList.UNKNOWN;
  }

  // The protocol.

  /** The same as {@link #change}, unless that is what it works for. */
  private void changeIfNew() {
    if (!wanted().equals(worksFor)) {
      change();
    }
  }

  /** Works for what this robot wants different in the latest view, if anything. */
  private void change() {
    Change wanted = wanted();
    worksFor = wanted;
    if (wanted.isVoidIn(view)) {
      synod.stop();
      return;
    }
    View base = view;
    ProcessId join = wanted.join();
    if (join != null) {
      if (!new Proposal(base).add(wanted).view().contains(join)) {
        giveUp();
        return;
      }
      askedIn = base.number() + 1;
    }
    suspense.rumour(base.number() + 1, nowNs);
    synod.propose(
        base.number() + 1,
        wanted.toValue(),
        wishes -> ViewFormat.toValue(proposal(base, wanted, wishes)),
        nowNs);
  }

  /**
   * Works for the decision of a number that somebody else proposed and that never came: its proposer
   * may have gone after it was decided. Where nothing was decided, the next view is as this one.
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
    return wants.in(view, phase == Phase.JOINING ? me : null, phase == Phase.LEAVING ? me : null);
  }

  private void learn(View learned) {
    long skippedFrom = askedIn;
    view = learned;
    boolean listed = learned.contains(me);
    if (phase == Phase.JOINING && listed) {
      settle(Phase.IN);
    } else if (phase == Phase.JOINING && skippedFrom > 0 && learned.number() > skippedFrom) {
      // A view that I never saw may have let me in, and a later one put me out again.
      wants.isIdle(me);
      port.givesUp(me);
      takeFreshId();
    } else if ((phase == Phase.LEAVING || phase == Phase.LEFT_HALFWAY) && !learned.mentions(me)) {
      // What was given up at its deadline has come about after all: nobody need ask again.
      isOut();
    } else if (phase == Phase.IN && !listed) {
      isPutOut();
    }
    suspense.learned(learned.number(), nowNs);
    change();
  }

  /** At the deadline, or when no view could take me in. */
  private void giveUp() {
    failed = true;
    if (phase == Phase.JOINING) {
      wants.isIdle(me);
      port.givesUp(me);
      me = freshProcess();
      askedIn = 0;
      settle(Phase.OUT);
    } else {
      settle(Phase.LEFT_HALFWAY);
    }
    synod.stop();
    change();
  }

  private void settle(Phase next) {
    phase = next;
    deadlineNs = Long.MAX_VALUE;
    boolean wantsNews = next != Phase.OUT || wants.hasOwnWord();
    queryAtNs = wantsNews ? nowNs + settings.queryMs() * NS_PER_MS : Long.MAX_VALUE;
  }

  /** Others gave me up: told, since a list that is null may also be on its way. */
  private void isPutOut() {
    wasPutOut = true;
    failed = true;
    settle(Phase.OUT);
  }

  private void isOut() {
    settle(Phase.OUT);
    unregistered = true;
    wasPutOut = false;
    failed = false;
  }

  private void takeFreshId() {
    me = freshProcess();
    askedIn = 0;
    port.asksFor(me);
  }

  private ProcessId freshProcess() {
    ProcessId id = port.freshProcess();
    wants.isMine(id);
    return id;
  }

  private final class Decrees implements SynodListener {
    @Override
    public void chosen(long number, Value value) {
      Set<RobotId> concerned = new TreeSet<>(acceptors);
      view.mentioned().forEach(id -> concerned.add(id.robot()));
      ViewFormat.read(number, value).mentioned().forEach(id -> concerned.add(id.robot()));
      concerned.remove(self);
      news.begin(number, concerned.size(), nowNs);
      for (RobotId robot : concerned) {
        SynodMessage decided = new SynodMessage.Decided(number, value);
        port.sendReliably(robot, decided, () -> news.settled(number));
      }
    }

    @Override
    public void learned(long number, Value value) {
      learn(ViewFormat.read(number, value));
    }

    @Override
    public void rumour(long number) {
      suspense.rumour(number, nowNs);
    }
  }
}
