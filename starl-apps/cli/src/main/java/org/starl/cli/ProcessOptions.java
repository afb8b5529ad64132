package org.starl.cli;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.processes.Fleet;
import org.starl.processes.FleetResult;
import org.starl.processes.FleetSettings;
import org.starl.processes.Kill;
import org.starl.random.Rng;
import org.starl.sim.Blueprint;
import org.starl.sim.Setting;
import org.starl.sim.fault.Crash;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.TimeRange;
import org.starl.sim.fault.Who;
import picocli.CommandLine.Option;

/** What {@code run} takes where robots are processes. */
final class ProcessOptions {

  /** For a robot or two: it starts fast and leaves the processors to the others. */
  private static final List<String> JAVA_OPTIONS =
      List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-Xmx128m");

  @Option(
      names = "--processes",
      description =
          "Each robot is an operating-system process over UDP on the loopback interface, in real"
              + " time, with a simulated body.")
  private boolean on;

  @Option(
      names = "--rounds",
      paramLabel = "N",
      description = "With --processes: each robot runs its app so often, each time as a new start.")
  private @Nullable String rounds;

  @Option(
      names = "--kill",
      paramLabel = "WHO@WHEN",
      description =
          "With --processes: kill -9 a robot's process: bot2@12s, or"
              + " 'bot2@app.location=MOVE_WAIT+1500ms', so long after its trace says so.")
  private List<String> kills = new ArrayList<>();

  /** @throws BadInput if there are options for processes, and no processes */
  boolean areOn() {
    if (!on && (rounds != null || !kills.isEmpty())) {
      throw new BadInput((rounds != null ? "--rounds" : "--kill") + ": expected --processes too");
    }
    return on;
  }

  /** What must follow on the command line to say the same again. */
  String replay() {
    StringBuilder line = new StringBuilder(" --processes");
    if (rounds != null) {
      line.append(" --rounds ").append(Shell.quote(rounds));
    }
    kills.forEach(kill -> line.append(" --kill ").append(Shell.quote(kill)));
    return line.toString();
  }

  /** Runs the robots of {@code blueprint}, which {@code words} describe to {@link RobotCommand}. */
  FleetResult run(Blueprint blueprint, List<String> words, PrintWriter err) throws IOException {
    FleetSettings settings = settings(blueprint);
    try (Fleet fleet = new Fleet(blueprint, command(words), settings, err::println)) {
      return fleet.run();
    }
  }

  /** Starts a robot of the run that {@code words} describe. */
  static List<String> command(List<String> words) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(JAVA_OPTIONS);
    command.addAll(List.of("-cp", absoluteClassPath(), Main.class.getName(), RobotCommand.NAME));
    command.addAll(words);
    return command;
  }

  private static String absoluteClassPath() {
    List<String> entries = new ArrayList<>();
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      entries.add(Path.of(entry).toAbsolutePath().toString());
    }
    return String.join(File.pathSeparator, entries);
  }

  private FleetSettings settings(Blueprint blueprint) {
    List<Kill> all = new ArrayList<>();
    List<RobotId> robots = blueprint.header().robots();
    for (String kill : kills) {
      Kill parsed = Kill.parse(kill);
      if (!robots.contains(parsed.who())) {
        throw new BadInput("--kill: " + BadInput.quote(kill) + ": expected one of " + robots);
      }
      all.add(parsed);
    }
    Rng rng = new Rng(blueprint.header().behaviourSeed()).fork("faults");
    for (Fault fault : blueprint.settings().get(Setting.FAULTS).faults()) {
      all.addAll(killsOf(fault, robots, rng));
    }
    if (blueprint.settings().get(Setting.CHAOS) != Envelope.NONE) {
      throw new BadInput("--chaos: with --processes: expected --loss, --delay, --kill");
    }
    int count = rounds == null ? 1 : (int) Numbers.whole("--rounds", rounds, 1, 1_000_000);
    return FleetSettings.within(limit(blueprint)).withRounds(count).withKills(all);
  }

  private static Duration limit(Blueprint blueprint) {
    Duration duration = blueprint.settings().get(Setting.DURATION);
    return duration.isZero() ? Duration.ofDays(365) : duration;
  }

  private static List<Kill> killsOf(Fault fault, List<RobotId> robots, Rng rng) {
    if (!(fault.harm() instanceof Crash crash)
        || crash.who().choice() != Who.Choice.NAMED
        || fault.span().isFinite()) {
      throw new BadInput(
          fault + ": with --processes: expected crash(NAME,at=TIME), without restart");
    }
    TimeRange at = fault.span().at();
    long atNs = rng.nextLong(at.leastNs(), at.mostNs());
    List<Kill> kills = new ArrayList<>();
    for (RobotId who : crash.who().named()) {
      if (!robots.contains(who)) {
        throw new BadInput(fault + ": expected one of " + robots);
      }
      kills.add(new Kill(who, null, atNs));
    }
    return kills;
  }
}
