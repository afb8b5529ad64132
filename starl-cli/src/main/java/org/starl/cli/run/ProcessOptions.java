package org.starl.cli.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.Shell;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.launch.JavaProcess;
import org.starl.launch.Kill;
import org.starl.launch.LaunchResult;
import org.starl.launch.LaunchSettings;
import org.starl.launch.Launcher;
import org.starl.launch.LiveMerge;
import org.starl.random.Rng;
import org.starl.sim.Setting;
import org.starl.sim.SimulationPlan;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.FaultEffect;
import org.starl.sim.fault.RobotSelector;
import org.starl.sim.fault.TimeRange;
import org.starl.trace.Vocabulary;
import picocli.CommandLine.Option;

/** The options of {@code run} for robots as processes. */
public final class ProcessOptions {

  private static final int HEAP_MB = 128;

  @Option(
      names = "--processes",
      description =
          "Run each robot as an operating-system process over UDP on the loopback interface, in"
              + " real time, with a simulated body.")
  private boolean on;

  @Option(
      names = "--rounds",
      paramLabel = "N",
      description =
          "With --processes: number of times that each robot runs its app, each time with a new"
              + " start of its program (default: 1).")
  private @Nullable String rounds;

  @Option(
      names = "--kill",
      paramLabel = "ROBOT@WHEN",
      description =
          "With --processes: kill a robot's process (kill -9) at a time (bot2@12s), or after a"
              + " variable of its trace first has a value ('bot2@app.location=MOVE_WAIT+1500ms')."
              + " May be repeated.")
  private List<String> kills = new ArrayList<>();

  /**
   * @throws BadInput if an option for processes is given without {@code --processes}
   */
  public boolean areOn() {
    if (!on && (rounds != null || !kills.isEmpty())) {
      throw new BadInput((rounds != null ? "--rounds" : "--kill") + " needs --processes");
    }
    return on;
  }

  /** The command that repeats the run whose settings are those of the command {@code simulated}. */
  public String again(String simulated) {
    return "repeat, with other timing: " + simulated + replay();
  }

  /** The options as part of a command line. */
  public String replay() {
    StringBuilder line = new StringBuilder(" --processes");
    if (rounds != null) {
      line.append(" --rounds ").append(Shell.quote(rounds));
    }
    kills.forEach(kill -> line.append(" --kill ").append(Shell.quote(kill)));
    return line.toString();
  }

  /**
   * Runs the robots of {@code plan}.
   *
   * @param words the options that make the plan
   * @param live receives the robots' events while they come; null for none
   */
  public LaunchResult run(
      SimulationPlan plan,
      List<String> words,
      Vocabulary vocabulary,
      @Nullable LiveMerge live,
      PrintWriter err)
      throws IOException {
    LaunchSettings settings = settings(plan);
    try (Launcher launcher =
        new Launcher(plan, command(words), vocabulary, settings, err::println)) {
      if (live != null) {
        launcher.show(live::accept);
      }
      return launcher.run();
    }
  }

  /** The command line of a robot's process, for a {@link Launcher}. */
  static List<String> command(List<String> words) {
    List<String> args = new ArrayList<>(List.of(RobotCommand.NAME));
    args.addAll(words);
    return JavaProcess.command(HEAP_MB, BaseCommand.MAIN, args);
  }

  private LaunchSettings settings(SimulationPlan plan) {
    List<Kill> all = new ArrayList<>();
    List<RobotId> robots = plan.header().robots();
    for (String kill : kills) {
      Kill parsed = Kill.parse(kill);
      if (!robots.contains(parsed.robot())) {
        throw new BadInput("--kill: " + BadInput.quote(kill) + ": expected one of " + robots);
      }
      all.add(parsed);
    }
    Rng rng = new Rng(plan.header().behaviourSeed()).fork("faults");
    for (Fault fault : plan.settings().get(Setting.FAULTS).faults()) {
      all.addAll(killsOf(fault, robots, rng));
    }
    if (plan.settings().get(Setting.CHAOS) != Envelope.NONE) {
      throw new BadInput(
          "--chaos cannot be used with --processes; expected --loss, --delay or --kill");
    }
    if (plan.settings().get(Setting.RADIO_RANGE) > 0) {
      throw new BadInput("radioRange cannot be used with --processes; expected --loss or --delay");
    }
    int count = rounds == null ? 1 : OptionValues.whole("--rounds", rounds, 1, 1_000_000);
    return new LaunchSettings(count, all, limit(plan), LaunchSettings.DEFAULT_QUIET);
  }

  private static Duration limit(SimulationPlan plan) {
    Duration duration = plan.settings().get(Setting.DURATION);
    return duration.isZero() ? Duration.ofDays(365) : duration;
  }

  private static List<Kill> killsOf(Fault fault, List<RobotId> robots, Rng rng) {
    FaultEffect effect = fault.effect();
    if (!effect.name().equals("crash")
        || effect.robots().choice() != RobotSelector.Choice.NAMED
        || fault.span().isFinite()) {
      throw new BadInput(
          fault + ": with --processes: expected crash(NAME,at=TIME), without restart");
    }
    TimeRange at = fault.span().at();
    long atNs = rng.nextLong(at.leastNs(), at.mostNs());
    List<Kill> kills = new ArrayList<>();
    for (RobotId robot : effect.robots().named()) {
      if (!robots.contains(robot)) {
        throw new BadInput(fault + ": expected one of " + robots);
      }
      kills.add(new Kill(robot, null, atNs));
    }
    return kills;
  }
}
