package org.starl.primitives.geocast;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.spec.FaultState;
import org.starl.spec.LemmaMonitor;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;

/**
 * The specification of geocast and broadcast (paper, section 4.2), after the package's contract:
 * {@code exclusion}, {@code deadline}, {@code once}, {@code acknowledged}, {@code Dismissed} and
 * {@code inclusion}. It uses the true bodies.
 * Exclusion and inclusion are about the whole interval, so they are checked at its end; an interval
 * that outlasts the run is not checked.
 *
 * <p>Inclusion is owed for robots that a copy has reached in time (or for all robots, if the origin
 * never sent a copy): the network decides which copies arrive. It is owed for all robots, too, if the
 * interval is long enough for the first copy to arrive, and ends with enough time without faults for
 * one repetition to reach them.
 */
public final class GeocastSpec extends LemmaMonitor {

  static final String EXCLUSION = "geocast.exclusion";
  static final String INCLUSION = "geocast.inclusion";
  static final String DEADLINE = "geocast.deadline";
  static final String ONCE = "geocast.once";
  static final String ACKNOWLEDGED = "geocast.acknowledged";
  static final String DISMISSED = "geocast.Dismissed";
  static final String ANSWERED = "geocast.answered";
  static final String GCASTFLAG = "geocast.Gcastflag";
  static final String REPEATED = "geocast.Repeated";

  /** No time is long enough for a copy to arrive certainly: the network loses some. */
  public static final long NEVER = Long.MAX_VALUE;

  /** Rounding of positions. */
  private static final double TOUCH_MM = 0.1;

  private final double positionErrorMm;
  private final GeocastSettings settings;
  private final long delayNs;
  private final Casts casts;
  private @Nullable CompletionCheck completion;
  private final FaultState faults = new FaultState();

  /** For a world without clock skew, and with position errors below 50 mm. */
  public GeocastSpec() {
    this(50, GeocastSettings.DEFAULT);
  }

  /** Inclusion is owed only for robots that a copy has reached. */
  public GeocastSpec(double positionErrorMm, GeocastSettings settings) {
    this(positionErrorMm, settings, NEVER);
  }

  /**
   * @param positionErrorMm the largest position error for which inclusion is owed, in mm; not for
   *     robots within twice this of the border, since their estimated position must be inside for
   *     certain
   * @param settings those of the robots
   * @param delayNs the longest delay of a copy without faults, in ns; {@link #NEVER} where messages
   *     are lost without faults
   */
  public GeocastSpec(double positionErrorMm, GeocastSettings settings, long delayNs) {
    this.positionErrorMm = positionErrorMm;
    this.settings = settings;
    this.delayNs = delayNs;
    casts = new Casts(2 * positionErrorMm, this::judge);
    lemma(
        EXCLUSION, "A robot outside the area during the whole interval does not get the message.");
    progress(
        INCLUSION,
        "A robot that is in the area throughout, and that the network lets a copy reach, gets the"
            + " message.");
    lemma(DEADLINE, "No robot gets the message after its interval is over.");
    lemma(ONCE, "No robot gets the message twice.");
    lemma(ACKNOWLEDGED, "A robot acknowledges only a message that it has got.");
    lemma(DISMISSED, "A copy that is not delivered was late, or its robot not surely in the area.");
  }

  /**
   * Also requires, of robots that acknowledge, that they do it at once, and that a sender knows when all have,
   * and repeats its messages in time until then.
   */
  public GeocastSpec answering() {
    lemma(ANSWERED, "A robot that has the message acknowledges each copy of it at once.");
    lemma(
        GCASTFLAG,
        "Gcastflag is true exactly if all have acknowledged the robot's messages, or their intervals are over.");
    lemma(
        REPEATED,
        "A sender repeats a message in time, no sooner, until all have it or its interval is over.");
    completion = new CompletionCheck(settings, faults);
    return this;
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new GeocastConformance());
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    casts.observe(event, report);
    faults.observe(event);
    if (completion != null) {
      completion.observe(event, report);
    }
    switch (event) {
      case Action action -> acted(action, report);
      case Sent sent -> sent(sent, report);
      case Delivered delivered -> reached(delivered);
      default -> {}
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    casts.finish(endNs, report);
  }

  private void acted(Action action, Report report) {
    switch (action.fact()) {
      case GeocastFact.deliver f -> delivered(action, f.m(), report);
      case GeocastFact.dismiss f -> {
        CastRecord cast = casts.of(action.source(), f.m());
        if (cast != null) {
          checkDismissed(action, f, cast, report);
        }
        // A dismissal as early is no excuse: clocks within the skew never give a reason for it.
        if (cast != null && f.errorMm() > positionErrorMm) {
          cast.excuse(action.robot());
        }
      }
      default -> {}
    }
  }

  private void checkDismissed(
      Action action, GeocastFact.dismiss f, CastRecord cast, Report report) {
    RobotId robot = action.robot();
    boolean isTrue =
        switch (f.reason()) {
          case LATE -> action.timeNs() > surelyOpenUntilNs(cast);
          case OUTSIDE -> casts.depthMm(cast, robot, action.timeNs()) <= 2 * f.errorMm() + TOUCH_MM;
          case EARLY -> true; // clocks that differ by more than they may
        };
    report.checked(DISMISSED);
    if (!isTrue) {
      String detail = "does not deliver " + cast.id + " as " + f.reason() + ", and it is not";
      report.violated(DISMISSED, action.timeNs(), List.of(robot), detail);
    }
  }

  private void delivered(Action action, GeocastId id, Report report) {
    RobotId robot = action.robot();
    CastRecord cast = casts.of(action.source(), id);
    report.checked(DEADLINE);
    if (cast == null) {
      String detail = "delivers " + id + ", whose interval is over";
      report.violated(DEADLINE, action.timeNs(), List.of(robot), detail);
      return;
    }
    report.checked(ONCE);
    report.checked(DISMISSED); // it was not
    if (!cast.delivered(robot, action.timeNs())) {
      String detail = "delivers " + cast.id + " again";
      report.violated(ONCE, action.timeNs(), List.of(robot), detail);
    }
    if (completion != null) {
      completion.mustAnswer(action, cast);
    }
  }

  private void sent(Sent sent, Report report) {
    switch (sent.message()) {
      case GeocastMessage.Copy<?> copy -> {
        CastRecord cast = casts.of(sent.channel(), copy.id());
        if (cast != null && sent.robot().equals(cast.origin) && sent.to().equals(Sent.ALL)) {
          cast.hasCopies = true;
        }
      }
      case GeocastMessage.Ack<?> ack -> acknowledged(sent, ack.id(), report);
      default -> {}
    }
  }

  private void acknowledged(Sent sent, GeocastId id, Report report) {
    CastRecord cast = casts.of(sent.channel(), id);
    if (cast != null) {
      report.checked(ACKNOWLEDGED);
      if (!cast.hasDelivered(sent.robot())) {
        String detail = "acknowledges " + cast.id + ", which it has not delivered";
        report.violated(ACKNOWLEDGED, sent.timeNs(), List.of(sent.robot()), detail);
      }
    }
  }

  private void reached(Delivered delivered) {
    if (!(delivered.message() instanceof GeocastMessage.Copy<?> copy)) {
      return;
    }
    CastRecord cast = casts.of(delivered.channel(), copy.id());
    if (cast != null
        && delivered.from().equals(cast.origin)
        && !cast.originRestarted
        && delivered.timeNs() <= surelyOpenUntilNs(cast)) {
      cast.reached(delivered.robot());
      if (completion != null && cast.hasDelivered(delivered.robot())) {
        completion.mustAnswer(delivered, cast);
      }
    }
  }

  private void judge(CastRecord cast, Report report) {
    for (int n = cast.deliveries(); n > 0; n--) {
      report.checked(EXCLUSION);
    }
    cast.intruders()
        .forEach((robot, timeNs) -> {
          String detail = "delivered " + cast.id + ", was outside " + cast.area;
          report.violated(EXCLUSION, timeNs, List.of(robot), detail);
        });
    for (RobotId robot : cast.required(reachesAll(cast))) {
      report.checked(INCLUSION);
      if (!cast.hasDelivered(robot)) {
        String detail = "never delivered " + cast.id + ", was in " + cast.area;
        report.violated(INCLUSION, cast.deadlineNs, List.of(robot), detail);
      }
    }
  }

  private boolean reachesAll(CastRecord cast) {
    long untilNs = surelyOpenUntilNs(cast);
    return delayNs != NEVER
        && untilNs - cast.startNs >= delayNs
        && faults.isCalm(untilNs, settings.reachNs(delayNs));
  }

  /** A copy that arrives later may be too late by the clock of its receiver. */
  private long surelyOpenUntilNs(CastRecord cast) {
    return cast.deadlineNs - 2 * settings.clockSkewNs();
  }
}
