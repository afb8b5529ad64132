package org.starl.sim.fault;

import static org.starl.sim.fault.ArgumentType.DISTANCE;
import static org.starl.sim.fault.ArgumentType.DURATION;
import static org.starl.sim.fault.ArgumentType.POSITIVE_SPEED;
import static org.starl.sim.fault.ArgumentType.PPM;
import static org.starl.sim.fault.ArgumentType.PROBABILITY;
import static org.starl.sim.fault.ArgumentType.SIGNED_DURATION;
import static org.starl.sim.fault.FaultGrammar.Row.row;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import org.starl.id.RobotId;
import org.starl.sim.net.LinkRule;
import org.starl.sim.net.Verdict;
import org.starl.sim.world.PositionNoise;
import org.starl.sim.world.Unsynced;

/** The faults of robots, of foreign bodies near them, and of attackers that send them datagrams. */
final class RobotFaults {

  private static final double USUAL_RAM_MM_PER_S = 300;

  static final FaultGrammar.Row CRASH =
      row(
          "crash(WHO,restart=5s,lose=unsynced)",
          "the program crashes; restart: after this time; lose: unsynced, some or nothing",
          RobotFaults::crash);

  static final List<FaultGrammar.Row> ROWS =
      List.of(
          row("stuck(WHO)", "the wheels do not turn", call -> impair(Impairment.ofWheels(0))),
          row(
              "slow(WHO,0.5)",
              "the wheels turn at this fraction of the commanded speed",
              call -> impair(Impairment.ofWheels(call.next("a fraction", PROBABILITY)))),
          row(
              "noise(WHO,30mm,3deg)",
              "fixes have this additional error, and report it in their bound",
              RobotFaults::noise),
          row(
              "dropout(WHO)",
              "no fixes come",
              call -> impair(Impairment.ofPositioning(PositionNoise.NONE, true, 0, 0))),
          row(
              "jump(WHO,300mm)",
              "fixes are shifted this far, and do not report it",
              RobotFaults::jump),
          row(
              "compute(WHO,20ms)",
              "each action takes this time, and the next one waits",
              call ->
                  impair(Impairment.ofTime(0, 0, call.next("the time of an action", DURATION)))),
          row(
              "drift(WHO,200ppm)",
              "the clock is too fast by this rate, or too slow: -200ppm",
              call -> impair(Impairment.ofTime(call.next("a drift", PPM), 0, 0))),
          row(
              "skew(WHO,50ms)",
              "the clock is ahead by this time, or behind: -50ms",
              call -> impair(Impairment.ofTime(0, call.next("a skew", SIGNED_DURATION), 0))),
          row(
              "disk(WHO,50ms)",
              "writes to stable storage survive a crash only after this additional time",
              call -> impair(Impairment.ofDisk(call.next("the time of a write", DURATION)))),
          row(
              "forget(WHO,50ms,1s)",
              "writes survive a crash only after this additional time; the program crashes when it"
                  + " sends while one is pending, and restarts without it after the second time",
              RobotFaults::forget),
          row(
              "ram(WHO,300mm/s)",
              "a foreign body drives into the robot again and again",
              call -> Intruder.fault(call.nextOr("a speed", POSITIVE_SPEED, USUAL_RAM_MM_PER_S))),
          row(
              "block(WHO)",
              "a foreign body parks in front of the robot",
              call -> Intruder.fault(0)),
          row(
              "forge(WHO,100ms)",
              "an attacker without the key sends changed recordings, at this mean interval",
              call -> attack(call, Eavesdropper::changed)),
          row(
              "replay(WHO,100ms)",
              "an attacker without the key sends old recordings, at this mean interval",
              call -> attack(call, Eavesdropper::recorded)),
          row(
              "flood(WHO,1ms)",
              "an attacker without the key sends random bytes, at this mean interval",
              call -> attack(call, Eavesdropper::noise)));

  private RobotFaults() {}

  /** Robots that are already down are skipped. */
  private static FaultAction crash(FaultArguments call) {
    Unsynced unsynced = call.keyed("lose", ArgumentType.UNSYNCED, Unsynced.LOST);
    return context -> {
      FaultTarget target = context.target();
      for (RobotId robot : context.robots()) {
        if (!target.isUp(robot)) {
          continue;
        }
        if (context.lastingNs() == Span.NEVER) {
          target.crash(robot);
        } else {
          target.crash(robot, context.lastingNs(), unsynced);
        }
      }
      return () -> {};
    };
  }

  /**
   * Crashes each robot once, at the worst moment: others have its message, and it has not what the
   * message may depend on. It is up again when the fault ends. Half of these faults wait for a write that
   * is rare, and for any robot's message, as the robot itself may only act: else all would be of those
   * writes that protocols do for each message, and none of an app's.
   */
  private static FaultAction forget(FaultArguments call) {
    Impairment slow = Impairment.ofDisk(call.next("the time of a write", DURATION));
    long downNs = call.next("the time until the restart", ArgumentType.POSITIVE_DURATION);
    return context -> {
      FaultTarget target = context.target();
      long endNs =
          context.lastingNs() == Span.NEVER ? Long.MAX_VALUE : target.nowNs() + context.lastingNs();
      Set<RobotId> armed = new TreeSet<>(context.robots());
      boolean isPicky = context.rng().nextBoolean(0.5);
      Runnable fast = impair(slow).begin(context);
      LinkRule.Handle watch =
          target
              .network()
              .install(copy -> {
                for (RobotId robot : isPicky ? List.copyOf(armed) : List.of(copy.from())) {
                  boolean isNow =
                      isPicky ? target.isRareUnflushed(robot) : target.unflushed(robot) > 0;
                  if (isNow && armed.remove(robot)) {
                    target.at(target.nowNs(), () -> forgetNow(target, robot, downNs, endNs));
                  }
                }
                return Verdict.PASS;
              });
      return () -> {
        watch.uninstall();
        fast.run();
      };
    };
  }

  private static void forgetNow(FaultTarget target, RobotId robot, long downNs, long endNs) {
    if (target.isUp(robot)) {
      target.crash(robot, Math.min(downNs, Math.max(0, endNs - target.nowNs())), Unsynced.LOST);
    }
  }

  private static FaultAction noise(FaultArguments call) {
    double mm = call.next("how far", DISTANCE);
    double rad = call.nextOr("an angle", ArgumentType.ANGLE, 0.0);
    if (rad > StrictMath.PI) {
      throw call.bad("expected an angle of at most 180deg");
    }
    return impair(Impairment.ofPositioning(new PositionNoise(mm, rad), false, 0, 0));
  }

  /** Fixes are shifted in a random direction. */
  private static FaultAction jump(FaultArguments call) {
    double mm = call.next("how far", DISTANCE);
    return context -> {
      double direction = 2 * StrictMath.PI * context.rng().nextDouble();
      double xMm = mm * StrictMath.cos(direction);
      double yMm = mm * StrictMath.sin(direction);
      return impair(Impairment.ofPositioning(PositionNoise.NONE, false, xMm, yMm)).begin(context);
    };
  }

  private static FaultAction impair(Impairment impairment) {
    return context -> {
      if (context.selector().isAll()) {
        return context.target().impair(null, impairment);
      }
      List<Runnable> ends = new ArrayList<>();
      for (RobotId robot : context.robots()) {
        ends.add(context.target().impair(robot, impairment));
      }
      return () -> ends.forEach(Runnable::run);
    };
  }

  /**
   * The attacker records all datagrams and sends its own to robots, at exponential intervals. Robots
   * without a key accept them; {@code sealed=yes} gives the robots a key.
   */
  private static FaultAction attack(FaultArguments call, Function<Eavesdropper, byte[]> next) {
    long meanNs = call.next("the mean interval", ArgumentType.INTERVAL);
    return context -> new Attack(context, meanNs, next)::end;
  }
}
