package org.starl.workload;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.spec.FaultState;
import org.starl.spec.LemmaMonitor;
import org.starl.spec.Within;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/**
 * The service that a workload's robots get in a calm world: no fault has been active, and every robot
 * has been up, for {@link FaultState#SETTLE_NS}.
 *
 * <ul>
 *   <li>{@code Prompt}: a request that a robot makes then is served, or has failed, within the bound.
 *       Each wait that a robot begins then ends when it is due.
 *   <li>{@code Granted}: it does not fail; only for primitives that need not fail then.
 * </ul>
 *
 * <p>Both are checked of requests during which the world stays calm.
 */
final class ServiceSpec extends LemmaMonitor {

  private static final String PROMPT = "service.Prompt";
  private static final String GRANTED = "service.Granted";

  private final boolean mayFail;
  private final Within<RobotId> requests;
  private final FaultState faults = new FaultState();

  /**
   * @param promptNs the bound
   * @param mayFail whether requests may fail in a calm world, too: no path may exist
   */
  ServiceSpec(long promptNs, boolean mayFail) {
    this.mayFail = mayFail;
    requests = new Within<>(promptNs);
    progress(PROMPT, "In a calm world every request is served, or has failed, within the bound.");
    if (!mayFail) {
      lemma(GRANTED, "In a calm world no request fails.");
    }
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    finish(event.timeNs(), report);
    faults.observe(event);
    if (!faults.isCalm(event.timeNs(), FaultState.SETTLE_NS)) {
      requests.clear();
    } else if (event instanceof Action action && action.fact() instanceof ClientFact fact) {
      acted(action, fact, report);
    }
  }

  private void acted(Action action, ClientFact fact, Report report) {
    switch (fact) {
      case ClientFact.late waking -> {
        // A clock may have been set right during a long wait.
        long sinceNs = FaultState.SETTLE_NS + (waking.ofMs() + waking.ms()) * Time.NS_PER_MS;
        if (faults.isCalm(action.timeNs(), sinceNs)) {
          report.checked(PROMPT);
          String detail = "wakes " + waking.ms() + " ms too late in a calm world";
          report.violated(PROMPT, action.timeNs(), List.of(action.robot()), detail);
        }
      }
      case ClientFact.ask made -> requests.start(action.robot(), action.timeNs());
      case ClientFact.served granted -> answered(action, "", report);
      case ClientFact.told refused ->
          answered(
              action,
              "its request of round " + refused.round() + " failed in a calm world",
              report);
    }
  }

  /** A request has an answer; {@code failure} is empty if it was served. */
  private void answered(Action action, String failure, Report report) {
    RobotId robot = action.robot();
    if (requests.stop(robot)) {
      report.checked(PROMPT);
      if (!mayFail) {
        report.checked(GRANTED);
        if (!failure.isEmpty()) {
          report.violated(GRANTED, action.timeNs(), List.of(robot), failure);
        }
      }
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    requests.expire(
        endNs,
        (robot, sinceNs, deadlineNs) -> {
          report.checked(PROMPT);
          String detail = "asked at " + Time.text(sinceNs, 3) + ", and has had no answer";
          report.overdue(PROMPT, deadlineNs, List.of(robot), detail);
        });
  }
}
