package org.starl.robot.udp;

import static org.starl.time.Time.NS_PER_MS;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.robot.udp.Beacon.Answer;
import org.starl.session.Nonce;
import org.starl.session.Start;

/**
 * The latest start of each other robot's program, and the robots that are suspected because they have
 * been silent for too long. Silence proves nothing: a suspected robot may be driving. Pure; one
 * thread at a time.
 *
 * <p>A beacon is <em>fresh</em> if it contains the nonce of this robot's own start: its sender has heard
 * this start, so it is not a recording of an earlier one. Only fresh beacons change anything. The
 * storage's epoch and the boot number say which of two starts is later; an earlier start is refused,
 * and so is another storage, since the promises that the old one contained are lost.
 */
final class Neighbours {

  /** The result of a beacon. */
  enum Verdict {
    /** A new start of the robot, the latest one from now on. */
    STARTED,
    /** The first beacon of that start after a silence. */
    APPEARED,
    HEARD,
    /** Not fresh: the sender needs this robot's nonce to prove that it is not a recording. */
    UNPROVEN,
    /** An earlier start, or another storage: see {@link #answerTo}. */
    REFUSED,
    /** Another machine runs a program of this robot's name. */
    TWIN,
    /** The sender refuses this robot's start. */
    REFUSES_US,
    /** Older than one that was heard: recorded and sent again, or overtaken. */
    OLD,
    /** From this robot's own start. */
    OWN,
    /** To or from a robot that the deployment does not have, or to another robot. */
    STRANGE
  }

  private static final long ANSWER_EVERY_NS = 100 * NS_PER_MS;

  private final RobotId self;
  private final Start mine;
  private final Participants deployment;
  private final long suspectAfterNs;
  private final SortedMap<RobotId, Neighbour> heard = new TreeMap<>();
  private final long beganNs;

  private static final class Neighbour {
    // The latest start; from storage until a beacon proves it again, and an address is known.
    private @Nullable Start start;
    private long count;
    private @Nullable InetSocketAddress address;
    // Of the last beacon that proved nothing; used until one does.
    private @Nullable InetSocketAddress hint;
    private Nonce claimed = Nonce.NONE;
    private long answeredNs = -ANSWER_EVERY_NS;
    private @Nullable Long lastNs;
    private boolean isPresent;
    // Whether its latest start is in this robot's storage.
    private boolean isStored;
    // Whether this robot's start is in its storage.
    private boolean knowsUs;
    private boolean isSuspected;
  }

  Neighbours(RobotId self, Start mine, Participants deployment, long suspectAfterNs, long nowNs) {
    this.self = self;
    this.mine = mine;
    this.deployment = deployment;
    this.suspectAfterNs = suspectAfterNs;
    this.beganNs = nowNs;
  }

  /** Remembers the latest start of another robot, of an earlier start of this one. */
  void remember(RobotId robot, Start start) {
    neighbour(robot).start = start;
  }

  /**
   * Takes a beacon that arrived at {@code nowNs} from {@code source}. If it is to this robot, its
   * signature was checked.
   */
  Verdict hear(Beacon beacon, InetSocketAddress source, long nowNs) {
    boolean isToUs = self.equals(beacon.to());
    if (!deployment.contains(beacon.robot()) || (beacon.to() != null && !isToUs)) {
      return Verdict.STRANGE;
    }
    if (beacon.robot().equals(self) && beacon.start().nonce().equals(mine.nonce())) {
      return Verdict.OWN;
    }
    Neighbour neighbour = neighbour(beacon.robot());
    if (!isToUs || !beacon.echo().equals(mine.nonce())) {
      return heardUnproven(neighbour, beacon, source, nowNs);
    }
    if (beacon.robot().equals(self)) {
      return Verdict.TWIN;
    }
    if (answerTo(beacon.robot(), beacon.start()).isRefusal()) {
      return heardRefused(neighbour, beacon, nowNs);
    }
    return heardFresh(neighbour, beacon, source, nowNs);
  }

  private Verdict heardRefused(Neighbour neighbour, Beacon beacon, long nowNs) {
    // Of two robots that refuse each other at least one has lost its storage, or has a copy. A
    // robot that lost it believes the first machine of each name, so it must not stop the others.
    if (beacon.answer().isRefusal() && !isAcceptedByAnother()) {
      return Verdict.REFUSES_US;
    }
    return mayAnswer(neighbour, nowNs) ? Verdict.REFUSED : Verdict.OLD;
  }

  private boolean isAcceptedByAnother() {
    for (Neighbour each : heard.values()) {
      if (each.isPresent) {
        return true;
      }
    }
    return false;
  }

  // An answer is a beacon for each beacon of whatever sender: bounded.
  private static boolean mayAnswer(Neighbour neighbour, long nowNs) {
    boolean mayAnswer = nowNs >= neighbour.answeredNs + ANSWER_EVERY_NS;
    if (mayAnswer) {
      neighbour.answeredNs = nowNs;
    }
    return mayAnswer;
  }

  private static Verdict heardUnproven(
      Neighbour neighbour, Beacon beacon, InetSocketAddress source, long nowNs) {
    neighbour.hint = source;
    neighbour.claimed = beacon.start().nonce();
    boolean needsNoAnswer = beacon.to() == null && isCurrent(neighbour, beacon.start());
    return !needsNoAnswer && mayAnswer(neighbour, nowNs) ? Verdict.UNPROVEN : Verdict.OLD;
  }

  private static Verdict heardFresh(
      Neighbour neighbour, Beacon beacon, InetSocketAddress source, long nowNs) {
    boolean isNewStart = !isCurrent(neighbour, beacon.start());
    if (!isNewStart && beacon.count() <= neighbour.count) {
      return Verdict.OLD;
    }
    neighbour.isStored &= !isNewStart;
    neighbour.start = beacon.start();
    neighbour.count = beacon.count();
    neighbour.address = source;
    neighbour.lastNs = nowNs;
    neighbour.isSuspected = false;
    if (beacon.answer().isRefusal()) {
      return Verdict.REFUSES_US;
    }
    neighbour.knowsUs |= beacon.answer() == Answer.ACCEPTED;
    boolean wasPresent = neighbour.isPresent;
    neighbour.isPresent = true;
    return isNewStart ? Verdict.STARTED : wasPresent ? Verdict.HEARD : Verdict.APPEARED;
  }

  /** Whether that start was proven in this robot's own present start. */
  private static boolean isCurrent(Neighbour neighbour, Start start) {
    return neighbour.address != null && start.equals(neighbour.start);
  }

  /** That start of the robot is in this robot's storage now. */
  void stored(RobotId robot, Start start) {
    Neighbour neighbour = neighbour(robot);
    neighbour.isStored |= isCurrent(neighbour, start);
  }

  /**
   * Whether more than half of the other robots have this robot's start in their storages. Two such
   * halves have a robot in common, which would refuse a second storage of this robot: so at most one
   * of its storages is ever known.
   */
  boolean isKnown() {
    return 2 * knownTo().size() > deployment.size() - 1;
  }

  /** The robots that have this robot's start in their storages, as far as they have said it. */
  List<RobotId> knownTo() {
    List<RobotId> robots = new ArrayList<>();
    heard.forEach((robot, each) -> {
      if (each.knowsUs) {
        robots.add(robot);
      }
    });
    return robots;
  }

  /** The answer to that start, which is proven to be fresh unless it is only about to be proven. */
  Answer answerTo(RobotId robot, Start start) {
    Neighbour neighbour = neighbour(robot);
    Start latest = neighbour.start;
    if (latest == null || start.equals(latest)) {
      return isCurrent(neighbour, start) && neighbour.isStored
          ? Answer.ACCEPTED
          : Answer.NOT_STORED;
    }
    if (start.epoch() != latest.epoch()) {
      return Answer.OTHER_STORAGE;
    }
    // A robot writes its boot number before it is heard, so two starts with one number are on two
    // machines.
    return start.boot() > latest.boot() ? Answer.NOT_STORED : Answer.LATER_START;
  }

  /** The answer to the start whose nonce is {@link #echoTo}. */
  Answer answerTo(RobotId robot) {
    return neighbour(robot).isStored ? Answer.ACCEPTED : Answer.NOT_STORED;
  }

  /** The nonce that the next beacon to that robot must contain: of its latest start, if proven. */
  Nonce echoTo(RobotId robot) {
    Neighbour neighbour = neighbour(robot);
    return neighbour.address == null || neighbour.start == null
        ? neighbour.claimed
        : neighbour.start.nonce();
  }

  /** Where that robot is: the source of its last fresh beacon, or else of its last; or null. */
  @Nullable InetSocketAddress addressOf(RobotId robot) {
    Neighbour neighbour = neighbour(robot);
    return neighbour.address == null ? neighbour.hint : neighbour.address;
  }

  /** The robots suspected since the last call, in order; robots that were never heard are included. */
  List<RobotId> newlySuspected(long nowNs) {
    List<RobotId> suspected = new ArrayList<>();
    for (RobotId robot : deployment.asList()) {
      if (robot.equals(self)) {
        continue;
      }
      Neighbour neighbour = neighbour(robot);
      long sinceNs = neighbour.lastNs == null ? beganNs : neighbour.lastNs;
      if (!neighbour.isSuspected && nowNs - sinceNs > suspectAfterNs) {
        neighbour.isSuspected = true;
        neighbour.isPresent = false;
        suspected.add(robot);
      }
    }
    return suspected;
  }

  /** The time of a robot's last fresh beacon; null if there was none. */
  @Nullable Long lastHeardNs(RobotId robot) {
    return neighbour(robot).lastNs;
  }

  private Neighbour neighbour(RobotId robot) {
    return heard.computeIfAbsent(robot, id -> new Neighbour());
  }
}
