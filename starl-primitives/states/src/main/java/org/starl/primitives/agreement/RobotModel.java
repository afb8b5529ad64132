package org.starl.primitives.agreement;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ToIntFunction;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodRobot.Packet;
import org.starl.primitives.exhaustive.StateSearch.Model;
import org.starl.spec.Monitor.Report;
import org.starl.spec.SpecReport;

/**
 * The states of robots, some of which call a protocol, and which crash and start again. Nothing outside
 * them has a state.
 *
 * @param <R> the robots
 */
public abstract class RobotModel<R> implements Model<R, Packet, String> {

  private final ToIntFunction<String> bounds;

  /**
   * @param bounds the number of each bound, by name: {@code robots}, {@code crashes}, {@code callers}
   *     and others
   */
  protected RobotModel(ToIntFunction<String> bounds) {
    this.bounds = bounds;
  }

  /** Reports which invariants are violated. */
  protected abstract void check(List<R> all, Report report);

  /** The number of a bound. */
  protected final int bound(String name) {
    return bounds.applyAsInt(name);
  }

  /** The robots' names. */
  public final Participants names() {
    List<RobotId> names = new ArrayList<>();
    for (int i = 0; i < size(); i++) {
      names.add(SynodRobot.robot(i));
    }
    return Participants.of(names);
  }

  /** Whether robot {@code i} calls the protocol. */
  protected final boolean isCaller(int i) {
    return bound("callers") == 0 || i < bound("callers");
  }

  /** Whether a robot may crash and start again. */
  protected final boolean mayRestart(List<R> all, ToIntFunction<R> starts) {
    return sum(all, starts) < size() + bound("crashes");
  }

  /** The sum of a number of each robot. */
  protected static <R> int sum(List<R> all, ToIntFunction<R> count) {
    return all.stream().mapToInt(count).sum();
  }

  @Override
  public final int size() {
    return bound("robots");
  }

  @Override
  public final int to(Packet packet) {
    return packet.to();
  }

  @Override
  public final String begin() {
    return "";
  }

  @Override
  public final Optional<String> violation(List<R> all, String none) {
    SpecReport report = new SpecReport();
    check(all, report);
    return report.violations().stream()
        .findFirst()
        .map(each -> each.lemma() + ": " + each.detail());
  }
}
