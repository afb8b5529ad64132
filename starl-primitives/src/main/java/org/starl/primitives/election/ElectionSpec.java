package org.starl.primitives.election;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.spec.Circumstances;
import org.starl.spec.Dues;
import org.starl.spec.Dues.Seat;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Variable;

/**
 * What every election of a run owes, as the package's contract has it: {@code Agreement}, {@code
 * Soundness}, and, where bounds are given, {@code Elected} and {@code Told}. Instances are told apart
 * by their names.
 */
public final class ElectionSpec implements Monitor {

  static final String AGREEMENT = "Agreement";
  static final String SOUNDNESS = "Soundness";
  static final String ELECTED = "Elected";
  static final String TOLD = "Told";

  private final Dues elected;
  private final Dues told;
  private final Circumstances circumstances = new Circumstances();
  private final Map<String, Ballots> elections = new TreeMap<>();

  /** Safety only. */
  public ElectionSpec() {
    this(Dues.NO_BOUND, Dues.NO_BOUND);
  }

  /**
   * Safety, and progress within bounds.
   *
   * @param electedWithinNs while a majority of the participants is up and no fault is under way: from
   *     {@code do_election}, or from the loss of the leader, until the live leader of the latest term
   *     is known to whoever takes part, in ns
   * @param toldWithinNs {@code Leader} is null no longer on end for whoever takes part, whatever
   *     happens, in ns: the elections' deadline
   */
  public ElectionSpec(long electedWithinNs, long toldWithinNs) {
    elected =
        new Dues(
            ELECTED,
            electedWithinNs,
            sinceNs -> "knows no live leader of the latest term since " + sinceNs + " ns");
    told = new Dues(TOLD, toldWithinNs, sinceNs -> "Leader is null since " + sinceNs + " ns");
  }

  @Override
  public List<String> lemmas() {
    return elected.isBounded()
        ? List.of(AGREEMENT, SOUNDNESS, ELECTED, TOLD)
        : List.of(AGREEMENT, SOUNDNESS);
  }

  @Override
  public String says(String lemma) {
    return switch (lemma) {
      case AGREEMENT -> "In one term all who know a leader know the same one.";
      case SOUNDNESS -> "Only who stood for election leads.";
      case ELECTED -> "All who take part come to know one live leader within the bound.";
      case TOLD -> "Nobody waits for a leader beyond the deadline without being told.";
      default -> "";
    };
  }

  @Override
  public List<String> ownLemmas() {
    return List.of(AGREEMENT);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new ElectionConformance());
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    expire(event.timeNs(), report);
    boolean changed = circumstances.observe(event);
    switch (event) {
      case Action action when ElectionTrace.isElection(action.source()) -> {
        acted(action);
        changed = true;
      }
      case Variable variable
          when ElectionTrace.isElection(variable.source())
              && variable.name().equals(ElectionTrace.LEADER) -> {
        ballots(variable.source()).shown(variable, report);
        changed = true;
      }
      case Fault fault when fault.name().equals(Fault.CRASH) -> forget(fault.robot());
      case Left left -> forget(left.robot());
      default -> {
        // Of no concern here.
      }
    }
    if (changed) {
      owe(event.timeNs(), report);
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    expire(endNs, report);
  }

  private void acted(Action action) {
    Ballots ballots = ballots(action.source());
    switch (action.name()) {
      case ElectionTrace.ELECTION ->
          ballots.made(
              Integer.parseInt(action.args().get(0)), ProcessId.parse(action.args().get(1)));
      case ElectionTrace.DO_ELECTION -> ballots.takesPart(action.robot());
      case ElectionTrace.CANDIDATE ->
          ballots.candidate(
              Long.parseLong(action.args().get(0)), ProcessId.parse(action.args().get(1)));
      default -> {
        // Not an action of this specification.
      }
    }
  }

  private void forget(RobotId robot) {
    elections.values().forEach(ballots -> ballots.crashed(robot));
  }

  /** Brings all debts up to date. */
  private void owe(long nowNs, Report report) {
    if (!elected.isBounded()) {
      return;
    }
    elections.forEach((source, ballots) -> {
      boolean assumed = circumstances.isFair() && ballots.hasMajorityUp();
      for (RobotId robot : ballots.robots()) {
        Seat seat = new Seat(source, robot);
        switch (ballots.standing(robot)) {
          case OUT -> {
            elected.settle(seat);
            told.settle(seat);
          }
          case FAILED -> {
            elected.settle(seat);
            told.meet(seat, report);
          }
          case SERVED -> {
            elected.meet(seat, report);
            told.meet(seat, report);
          }
          case MISLED -> {
            elected.owe(seat, nowNs);
            told.meet(seat, report);
          }
          case WAITING -> {
            elected.owe(seat, nowNs);
            told.owe(seat, nowNs);
          }
        }
        elected.assume(seat, assumed, nowNs);
      }
    });
  }

  private void expire(long nowNs, Report report) {
    elected.expire(nowNs, report);
    told.expire(nowNs, report);
  }

  private Ballots ballots(String source) {
    return elections.computeIfAbsent(source, s -> new Ballots(s, circumstances));
  }
}
