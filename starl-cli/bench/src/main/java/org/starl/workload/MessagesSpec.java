package org.starl.workload;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.comms.Reliability;
import org.starl.id.RobotId;
import org.starl.spec.FaultState;
import org.starl.spec.LemmaMonitor;
import org.starl.spec.Within;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.workload.MailFact.Care;
import org.starl.workload.MailFact.Mailed;

/**
 * The promises of {@code gvh.comms}, for the letters of {@link MessagesClient}.
 *
 * <ul>
 *   <li>{@code Genuine}: a letter that is handled was sent to this robot on this channel, which is
 *       open, and advances the logical clock to its own. Its own is above each that its sender knew.
 *   <li>{@code Once}: a reliable letter is handled at most once in each start of the receiver.
 *   <li>{@code Fresh}: no letter of a sender's earlier start is handled after one of a later start,
 *       and no two starts have one number.
 *   <li>{@code Handled}: a receipt that says delivered is true.
 *   <li>{@code Settled}: while no fault is active and the sender is up, a reliable letter is
 *       delivered or given up by its deadline; while the receiver is up, too, it is delivered within
 *       the bound. It is given up at once if its channel closes, and never earlier than it must.
 *   <li>{@code Received}: in a calm world each plain letter is handled by each receiver, once.
 *   <li>{@code Paced}: no datagram is sent twice at one time, and a letter is sent again only after the wait
 *       that its reliability says, which grows from one time to the next.
 * </ul>
 */
final class MessagesSpec extends LemmaMonitor {

  /** A network that may lose letters without a fault. */
  static final long NEVER = Long.MAX_VALUE;

  private static final String GENUINE = "messages.Genuine";
  private static final String ONCE = "messages.Once";
  private static final String FRESH = "messages.Fresh";
  private static final String HANDLED = "messages.Handled";
  private static final String SETTLED = "messages.Settled";
  private static final String RECEIVED = "messages.Received";
  private static final String PACED = "messages.Paced";

  /** By how much a deadline may be late: a timer set by a clock that a fault has just left. */
  private static final long LATE_NS = 2 * Time.NS_PER_S;

  private static final double ROUNDED_NS = 1_000;

  private final FaultState faults = new FaultState();
  private final Set<RobotId> robots = new TreeSet<>();
  private final Map<RobotId, Program> programs = new TreeMap<>();
  private final Map<LetterId, Sent> sent = new TreeMap<>();
  // With the least logical clock of its receiver then: that of the acknowledgement is no lower.
  private final Map<Arrival, Long> everHandled = new HashMap<>();
  private final Map<RobotId, Integer> newestStarts = new TreeMap<>();
  private final Within<LetterId> closed = new Within<>(0);
  private final Within<LetterId> deliveries;
  private final Within<LetterId> brief =
      new Within<>(MessagesClient.BRIEF.deadlineMs() * Time.NS_PER_MS + LATE_NS);
  private final Within<LetterId> lasting =
      new Within<>(Reliability.DEFAULT.deadlineMs() * Time.NS_PER_MS + LATE_NS);
  private final @Nullable Within<Arrival> arrivals;

  private record LetterId(RobotId from, int boot, int number) implements Comparable<LetterId> {
    @Override
    public int compareTo(LetterId other) {
      int byRobot = from.compareTo(other.from);
      int byBoot = byRobot != 0 ? byRobot : Integer.compare(boot, other.boot);
      return byBoot != 0 ? byBoot : Integer.compare(number, other.number);
    }

    @Override
    public String toString() {
      return "letter " + number + " of " + from + "'s start " + boot;
    }
  }

  private record Arrival(LetterId letter, RobotId to) {}

  /**
   * @param afterClock the latest logical clock that its sender is known to have had
   */
  private record Sent(Mailed letter, long atNs, long afterClock) {
    boolean isPlain() {
      return letter.care() == Care.NONE;
    }

    boolean isTo(RobotId robot, LetterId id) {
      return letter.to().map(robot::equals).orElse(!robot.equals(id.from));
    }
  }

  /** How often a letter has been sent, and when for the last time. */
  private record Transmissions(int count, long latestNs) {
    static final Transmissions NONE = new Transmissions(0, 0);
  }

  /** What a robot has done since its latest start. */
  private static final class Program {
    int boot;
    long clock;
    final Set<LetterId> unsettled = new TreeSet<>();
    final Set<LetterId> handled = new TreeSet<>();
    final Map<RobotId, Integer> newestBoots = new TreeMap<>();
    final Set<Instance> open = new TreeSet<>();
    final Map<LetterId, Transmissions> transmissions = new TreeMap<>(); // of unsettled ones
    final Set<Long> transmitted = new TreeSet<>();
    long transmittedNs;
  }

  /**
   * @param withinNs bound on a reliable letter's way, lost copies included
   * @param arrivesNs bound on a plain letter's way; {@link #NEVER} if the network loses some
   */
  MessagesSpec(long withinNs, long arrivesNs) {
    deliveries = new Within<>(withinNs);
    arrivals = arrivesNs == NEVER ? null : new Within<>(arrivesNs);
    lemma(GENUINE, "Every letter that is handled was sent to this robot on this open channel.");
    lemma(ONCE, "No start of a robot handles a reliable letter twice.");
    lemma(FRESH, "A robot that has heard of a sender's restart handles no letter from before.");
    lemma(HANDLED, "A letter that was delivered by its receipt has been handled.");
    progress(SETTLED, "Every reliable letter is delivered, or given up by its deadline.");
    progress(RECEIVED, "In a calm world every plain letter is handled once by each receiver.");
    lemma(
        PACED, "Between two transmissions of a letter time passes, and more before each next one.");
    if (arrivals == null) {
      never(RECEIVED, "the network loses messages");
    }
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    finish(event.timeNs(), report);
    if (event instanceof Joined joined) {
      robots.add(joined.robot());
    }
    if (faults.observe(event)) {
      changed(event);
    }
    if (arrivals != null && !isCalm(event.timeNs())) {
      arrivals.clear();
    }
    if (event instanceof TraceEvent.Sent datagram) {
      transmitted(datagram, report);
    } else if (event instanceof Action action && action.fact() instanceof MailFact fact) {
      acted(action, fact, report);
    }
  }

  private void transmitted(TraceEvent.Sent datagram, Report report) {
    RobotId robot = datagram.robot();
    Program self = programs.computeIfAbsent(robot, any -> new Program());
    if (datagram.timeNs() != self.transmittedNs) {
      self.transmittedNs = datagram.timeNs();
      self.transmitted.clear();
    }
    if (datagram.message() instanceof MessagesClient.Letter letter) {
      LetterId id = new LetterId(robot, letter.boot(), letter.number());
      if (self.unsettled.contains(id)) {
        repeated(datagram, self, id, report);
      }
    }
    report.checked(PACED);
    if (!self.transmitted.add(datagram.seq())) {
      String detail = "sends its datagram " + datagram.seq() + " twice at once";
      report.violated(PACED, datagram.timeNs(), List.of(robot), detail);
    }
  }

  private void repeated(TraceEvent.Sent datagram, Program self, LetterId id, Report report) {
    RobotId robot = datagram.robot();
    Transmissions before = self.transmissions.getOrDefault(id, Transmissions.NONE);
    int count = before.count + 1;
    self.transmissions.put(id, new Transmissions(count, datagram.timeNs()));
    if (before.count > 0
        && datagram.timeNs() - before.latestNs < leastWaitNs(reliability(id), before.count)
        && faults.isClockRight(robot, before.latestNs)) {
      String detail = "sends " + id + " again too soon, for the time " + count;
      report.violated(PACED, datagram.timeNs(), List.of(robot), detail);
    }
  }

  /** The wait after so many transmissions. */
  private static double leastWaitNs(Reliability used, int transmissions) {
    double ms = used.firstRetryMs() * StrictMath.pow(used.backoff(), transmissions - 1);
    return Math.min(ms, (double) used.maxWaitMs()) * Time.NS_PER_MS - ROUNDED_NS;
  }

  private Reliability reliability(LetterId letter) {
    Sent known = sent.get(letter);
    boolean isBrief = known != null && known.letter.care() == Care.BRIEF;
    return isBrief ? MessagesClient.BRIEF : Reliability.DEFAULT;
  }

  private boolean isCalm(long nowNs) {
    return faults.isCalm(nowNs, FaultState.SETTLE_NS);
  }

  private void changed(TraceEvent event) {
    RobotId robot = event.robot();
    boolean isEnd =
        event instanceof Left || (event instanceof Fault fault && fault.name().equals(Fault.CRASH));
    if (isEnd) {
      programs.remove(robot);
      for (Within<LetterId> each : List.of(closed, deliveries, brief, lasting)) {
        // A program that has ended settles nothing.
        sent.keySet().stream().filter(id -> id.from.equals(robot)).forEach(each::stop);
      }
    }
    long nowNs = event.timeNs();
    boolean isFaultFree = faults.isFaultFree();
    for (Within<LetterId> each : List.of(deliveries, brief, lasting)) {
      each.assumeAll(isFaultFree, nowNs);
    }
    deliveries.assumeEach(this::isReceiverUp, nowNs);
  }

  private boolean isReceiverUp(LetterId letter) {
    Sent known = sent.get(letter);
    return known != null && known.letter.to().map(faults::isUp).orElse(true);
  }

  private void acted(Action action, MailFact fact, Report report) {
    RobotId robot = action.robot();
    Program self = programs.computeIfAbsent(robot, any -> new Program());
    switch (fact) {
      case MailFact.Opened opened -> self.open.add(opened.channel());
      case MailFact.Closed closing -> closed(action, self, closing.channel());
      case Mailed letter ->
          sent(action, self, new LetterId(robot, letter.boot(), letter.number()), letter, report);
      case MailFact.Handled letter -> handled(action, self, letter, report);
      case MailFact.Delivered letter -> {
        LetterId id = new LetterId(robot, letter.boot(), letter.number());
        Long clock = everHandled.get(new Arrival(id, letter.to()));
        check(HANDLED, clock != null, action, id + " is told delivered, but is not", report);
        self.clock = Math.max(self.clock, clock == null ? 0 : clock);
        settled(action, self, id, report);
      }
      case MailFact.Failed letter -> {
        LetterId id = new LetterId(robot, letter.boot(), letter.number());
        check(SETTLED, !isTooEarly(action, self, id), action, id + " fails too early", report);
        settled(action, self, id, report);
      }
    }
  }

  private void closed(Action action, Program self, Instance channel) {
    self.open.remove(channel);
    for (LetterId letter : self.unsettled) {
      Sent known = sent.get(letter);
      if (known != null && known.letter.channel().equals(channel)) {
        closed.start(letter, action.timeNs());
      }
    }
  }

  private void sent(Action action, Program self, LetterId letter, Mailed mailed, Report report) {
    long nowNs = action.timeNs();
    Sent what = new Sent(mailed, nowNs, self.clock);
    sent.put(letter, what);
    if (self.boot != letter.boot) {
      Integer earlier = newestStarts.put(letter.from, letter.boot);
      boolean isNew = earlier == null || earlier < letter.boot;
      check(FRESH, isNew, action, letter + " after its start " + earlier, report);
      self.boot = letter.boot;
    }
    if (!what.isPlain()) {
      self.unsettled.add(letter);
      (mailed.care() == Care.BRIEF ? brief : lasting).start(letter, nowNs);
      // The other channel is closed at times.
      if (mailed.channel().xid().equals("letters")) {
        deliveries.start(letter, nowNs);
        deliveries.assume(letter, isReceiverUp(letter), nowNs);
      }
    } else if (arrivals != null && isCalm(nowNs)) {
      for (RobotId robot : robots) {
        if (what.isTo(robot, letter)) {
          arrivals.start(new Arrival(letter, robot), nowNs);
        }
      }
    }
  }

  private void handled(Action action, Program self, MailFact.Handled handled, Report report) {
    LetterId letter = new LetterId(handled.from(), handled.boot(), handled.number());
    Instance channel = handled.channel();
    Sent known = sent.get(letter);
    long itsClock = handled.itsClock();
    long clock = handled.clock();
    self.clock = clock;
    boolean isGenuine =
        known != null
            && known.letter.channel().equals(channel)
            && known.isTo(action.robot(), letter)
            && self.open.contains(channel)
            && clock >= itsClock
            && itsClock > known.afterClock
            && itsClock >= letter.number; // the clock ticks for each letter
    check(GENUINE, isGenuine, action, letter + " on " + channel + ": not so sent", report);
    boolean isFirst = self.handled.add(letter);
    if (known != null && known.isPlain()) {
      if (arrivals != null && arrivals.stop(new Arrival(letter, action.robot()))) {
        report.checked(RECEIVED);
      } else if (!isFirst && isCalm(action.timeNs())) {
        check(RECEIVED, false, action, letter + " a second time", report);
      }
    } else {
      check(ONCE, isFirst, action, letter + " a second time", report);
    }
    int newest = self.newestBoots.merge(letter.from, letter.boot, Math::max);
    check(FRESH, letter.boot == newest, action, letter + " after its start " + newest, report);
    everHandled.merge(new Arrival(letter, action.robot()), clock, Math::min);
  }

  private void settled(Action action, Program self, LetterId letter, Report report) {
    self.unsettled.remove(letter);
    self.transmissions.remove(letter);
    closed.stop(letter);
    deliveries.stop(letter);
    boolean wasBrief = brief.stop(letter);
    boolean wasLasting = lasting.stop(letter);
    if (wasBrief || wasLasting) {
      report.checked(SETTLED);
    } else {
      check(SETTLED, false, action, letter + " is settled a second time", report);
    }
  }

  /** Whether a letter on an open channel is given up before its deadline and its last retry. */
  private boolean isTooEarly(Action action, Program self, LetterId letter) {
    Sent known = sent.get(letter);
    if (known == null || !self.open.contains(known.letter.channel())) {
      return false;
    }
    Reliability used = reliability(letter);
    return faults.isClockRight(action.robot(), known.atNs)
        && action.timeNs() - known.atNs < used.deadlineMs() * Time.NS_PER_MS
        && self.transmissions.getOrDefault(letter, Transmissions.NONE).count <= used.maxRetries();
  }

  private static void check(
      String lemma, boolean holds, Action action, String detail, Report report) {
    report.checked(lemma);
    if (!holds) {
      report.violated(lemma, action.timeNs(), List.of(action.robot()), detail);
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    expire(closed, endNs, report);
    expire(deliveries, endNs, report);
    expire(brief, endNs, report);
    expire(lasting, endNs, report);
    if (arrivals != null) {
      arrivals.expire(
          endNs,
          (arrival, sinceNs, deadlineNs) -> {
            report.checked(RECEIVED);
            String detail = arrival.letter + " has not arrived";
            report.overdue(RECEIVED, deadlineNs, List.of(arrival.to), detail);
          });
    }
  }

  private static void expire(Within<LetterId> letters, long endNs, Report report) {
    letters.expire(
        endNs,
        (letter, sinceNs, deadlineNs) -> {
          report.checked(SETTLED);
          String detail = letter + " is not settled since " + Time.text(sinceNs, 3);
          report.overdue(SETTLED, deadlineNs, List.of(letter.from), detail);
        });
  }
}
