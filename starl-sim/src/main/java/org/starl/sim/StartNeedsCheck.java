package org.starl.sim;

import java.util.Collection;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.platform.StartNeeds;

/**
 * Compares what the programs need at their starts with the settings and the start positions of a
 * run. Starts that were drawn too near to each other are drawn again, farther apart, unless the user
 * gave {@code startSpacing}; programs are
 * created at the start of the run, before their first fix.
 */
final class StartNeedsCheck {

  private final SimulationPlan plan;
  private final Consumer<List<RobotSpec>> mover;
  private List<RobotSpec> starts;
  private StartNeeds met = new StartNeeds("", 0, 0, 0, 0);

  /**
   * @param mover moves all bodies to other starts
   */
  StartNeedsCheck(SimulationPlan plan, Consumer<List<RobotSpec>> mover) {
    this.plan = plan;
    this.mover = mover;
    starts = plan.robots();
  }

  /** @throws UnmetNeeds if the needs are not met and starts cannot be drawn again */
  void require(StartNeeds needs, Collection<SimRobot> robots) {
    if (needs.equals(met)) {
      return;
    }
    checkSettings(needs);
    // Robots compare measured positions, which may be nearer to each other than the true ones.
    double noiseMm = 2 * plan.settings().positionNoise().boundMm();
    double spacingMm = Math.max(needs.spacingMm(), met.spacingMm()) + noiseMm;
    double clearanceMm = Math.max(needs.clearanceMm(), met.clearanceMm());
    StartPair nearest = StartPair.nearest(starts);
    boolean isNear = nearest != null && nearest.mm() < spacingMm;
    BiFunction<Double, Double, List<RobotSpec>> placement = plan.placement();
    double spacing = plan.settings().get(Setting.START_SPACING);
    boolean mayDraw =
        placement != null
            && !plan.settings().has(Setting.START_SPACING)
            && robots.stream().noneMatch(SimRobot::hasFix);
    if (isNear && !mayDraw) {
      throw new UnmetNeeds(
          nearest
              + ": expected at least %.0f mm for %s".formatted(spacingMm - noiseMm, needs.of())
              + (noiseMm == 0 ? "" : " and %.0f mm for positionNoise".formatted(noiseMm))
              + (placement == null ? "" : remedy(spacingMm, spacing)));
    }
    if (placement != null && mayDraw && (isNear || !areClear(clearanceMm))) {
      starts = drawn(placement, spacingMm, clearanceMm);
      mover.accept(starts);
    }
    met = needs;
  }

  private List<RobotSpec> drawn(
      BiFunction<Double, Double, List<RobotSpec>> placement, double spacingMm, double clearanceMm) {
    try {
      return placement.apply(spacingMm, Math.max(clearanceMm, plan.settings().robotRadiusMm()));
    } catch (BadInput noRoom) {
      throw new UnmetNeeds(String.valueOf(noRoom.getMessage()));
    }
  }

  private boolean areClear(double clearanceMm) {
    double widthMm = plan.settings().get(Setting.FLOOR_WIDTH);
    double heightMm = plan.settings().get(Setting.FLOOR_HEIGHT);
    return starts.stream()
        .map(start -> start.start().at())
        .allMatch(at ->
            Math.min(at.xMm(), widthMm - at.xMm()) >= clearanceMm
                && Math.min(at.yMm(), heightMm - at.yMm()) >= clearanceMm
                && plan.obstacles().distanceMm(at) > clearanceMm);
  }

  private String remedy(double spacingMm, double spacing) {
    double radii = spacingMm / plan.settings().robotRadiusMm();
    return ": startSpacing=%s, expected at least %.2f"
        .formatted(Quantities.numberText(spacing), StrictMath.ceil(100 * radii) / 100);
  }

  private void checkSettings(StartNeeds needs) {
    SimSettings settings = plan.settings();
    double noiseMm = settings.positionNoise().boundMm();
    if (noiseMm > needs.positionErrorMm()) {
      throw new UnmetNeeds(
          "%s=%s: expected at most %s for %s"
              .formatted(
                  Setting.POSITION_NOISE,
                  Quantities.distanceText(noiseMm),
                  Quantities.distanceText(needs.positionErrorMm()),
                  needs.of()));
    }
    long delayNs = settings.messageDelay().shortestNs();
    long leastNs =
        Math.addExact(2 * delayNs, 2 * settings.stableDelayNs()) + settings.computeTimeNs();
    if (leastNs >= needs.answerNs() && plan.robots().size() > 1) {
      throw new UnmetNeeds(
          "%s=%s, %s=%s, %s=%s: an answer takes at least %s, expected less than %s for %s"
              .formatted(
                  Setting.MESSAGE_DELAY,
                  settings.messageDelay(),
                  Setting.STABLE_DELAY,
                  Quantities.durationText(settings.stableDelayNs()),
                  Setting.COMPUTE_TIME,
                  Quantities.durationText(settings.computeTimeNs()),
                  Quantities.durationText(leastNs),
                  Quantities.durationText(needs.answerNs()),
                  needs.of()));
    }
  }
}
