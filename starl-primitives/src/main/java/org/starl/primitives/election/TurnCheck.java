package org.starl.primitives.election;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.election.ElectionMessage.Candidacy;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor.Report;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;

/**
 * Checks that no robot begins to propose before its strategy says so, by the candidates that it has heard. Only
 * the first proposal of a candidacy is checked: later ones are repetitions.
 */
final class TurnCheck {

  private final FaultState faults;
  private @Nullable ElectionStrategy strategy;
  private long deltaNs;

  /** The latest candidacy of another robot. */
  private record Heard(ProcessId from, long draw, long atNs) {}

  /** A robot's candidacy: since when, and which other candidates it has heard. */
  private static final class Turn {
    private final long term;
    private final long beganNs;
    private final Map<ProcessId, Heard> heard = new TreeMap<>();
    private long draw;
    private final long drawBefore;
    private boolean hasProposed;
    // The candidate to propose, unless a promise reports a vote.
    private @Nullable ProcessId first;
    private boolean isBound;

    Turn(long term, long drawBefore, long beganNs) {
      this.term = term;
      this.drawBefore = drawBefore;
      this.beganNs = beganNs;
    }

    /** The draw before one of this term: after a failure a robot stands in the same term again. */
    private long drawBefore(long next) {
      return next == term ? drawBefore : draw;
    }
  }

  private @Nullable Delivered latest;
  private final Map<ProcessKey, Turn> turns = new LinkedHashMap<>();

  /** Checks nothing before {@link #begin}. */
  TurnCheck(FaultState faults) {
    this.faults = faults;
  }

  /** Checks elections with these settings from now on. */
  void begin(ElectionSettings settings) {
    strategy = settings.strategy();
    deltaNs = settings.deltaMs() * Time.NS_PER_MS;
  }

  /** The robot stands in this term. It has heard no candidate, but for one that makes it stand. */
  void stands(ProcessKey key, long term, long nowNs) {
    Turn before = turns.get(key);
    Turn turn = new Turn(term, before == null ? 0 : before.drawBefore(term), nowNs);
    turns.put(key, turn);
    Delivered cause = latest;
    if (cause != null
        && cause.timeNs() == nowNs
        && key.equals(new ProcessKey(cause.channel(), cause.robot()))) {
      hears(turn, cause);
    }
  }

  /** Whether the robot hears another candidate of its term for the first time. */
  boolean isNew(Delivered got, ElectionMessage message) {
    Turn turn = turns.get(new ProcessKey(got.channel(), got.robot()));
    return turn != null
        && message instanceof Candidacy
        && message.term() == turn.term
        && !message.from().robot().equals(got.robot())
        && !turn.heard.containsKey(message.from());
  }

  void ended(RobotId robot) {
    turns.keySet().removeIf(key -> key.robot().equals(robot));
  }

  void observe(TraceEvent event, Report report) {
    if (event instanceof Delivered got && got.message() instanceof ElectionMessage) {
      latest = got;
      Turn turn = turns.get(new ProcessKey(got.channel(), got.robot()));
      if (turn != null) {
        hears(turn, got);
      }
    } else if (event instanceof Delivered got && got.message() instanceof Promise promise) {
      Turn turn = turns.get(new ProcessKey(got.channel().owner(), got.robot()));
      if (turn != null && promise.number() == turn.term) {
        turn.isBound |= promise.vote() != null;
      }
    } else if (event instanceof Sent sent) {
      Turn turn = turns.get(new ProcessKey(sent.channel().owner(), sent.robot()));
      if (turn != null && sent.message() instanceof Candidacy own) {
        turn.draw = own.draw();
        if (own.draw() == turn.drawBefore && strategy != null) {
          String detail =
              sent.channel() + ": has in term " + turn.term + " the draw of the term before";
          report.violated(ElectionSpec.TURN, sent.timeNs(), List.of(sent.robot()), detail);
        }
      } else if (turn != null && sent.message() instanceof Prepare prepare) {
        if (prepare.number() < turn.term && strategy != null) {
          String detail = sent.channel() + ": " + prepare + " while it stands in term " + turn.term;
          report.violated(ElectionSpec.TURN, sent.timeNs(), List.of(sent.robot()), detail);
        } else if (!turn.hasProposed && prepare.number() == turn.term) {
          turn.hasProposed = true;
          judge(turn, prepare.ballot().proposer(), sent, report);
        }
      } else if (turn != null && sent.message() instanceof Accept accept) {
        ProcessId first = accept.number() == turn.term && !turn.isBound ? turn.first : null;
        if (first != null && !accept.value().equals(ElectionProtocol.toValue(first))) {
          String detail = sent.channel() + ": does not propose " + first + ", which comes first";
          report.violated(ElectionSpec.TURN, sent.timeNs(), List.of(sent.robot()), detail);
        }
      }
    }
  }

  private static void hears(Turn turn, Delivered got) {
    if (got.message() instanceof ElectionMessage message) {
      ProcessId from = message.from();
      // An earlier program of the sender is dead.
      turn.heard.keySet().removeIf(id -> id.robot().equals(from.robot()) && id.inc() < from.inc());
      if (message instanceof Candidacy candidacy && candidacy.term() == turn.term) {
        turn.heard.put(from, new Heard(from, candidacy.draw(), got.timeNs()));
      }
    }
  }

  private void judge(Turn turn, ProcessId me, Sent sent, Report report) {
    if (strategy == null || !faults.isClockRight(sent.robot(), turn.beganNs)) {
      return;
    }
    report.checked(ElectionSpec.TURN);
    boolean isBully = strategy == ElectionStrategy.BULLY;
    long heardSinceNs =
        sent.timeNs() - deltaNs * (isBully ? ElectionStrategy.LISTEN : ElectionStrategy.DECIDE);
    List<Heard> earlier =
        turn.heard.values().stream()
            .filter(other -> other.atNs() > heardSinceNs)
            .filter(other -> isBully ? other.from().compareTo(me) > 0 : other.draw() > turn.draw)
            .sorted(Comparator.comparingLong(Heard::draw).reversed())
            .collect(Collectors.toList());
    turn.first = earlier.isEmpty() ? me : earlier.get(0).from();
    long before = earlier.size();
    long waitNs = deltaNs * (ElectionStrategy.LISTEN + before * ElectionStrategy.DECIDE);
    if (sent.timeNs() - turn.beganNs < waitNs || (isBully && before > 0)) {
      report.violated(
          ElectionSpec.TURN,
          sent.timeNs(),
          List.of(sent.robot()),
          String.format(
              "%s: proposes in term %s before %s candidates that come first",
              sent.channel(), turn.term, before));
    }
  }
}
