package org.starl.cli.deploy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.MissingDependencyException;
import org.starl.cli.command.OptionValues;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.input.Quantities;
import org.starl.launch.Cameras;
import org.starl.launch.DeploymentFile;
import org.starl.launch.Take;
import org.starl.robot.PoseFeeds;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.optitrack.Axes;
import org.starl.robot.optitrack.PoseSource;
import org.starl.robot.realtime.RealClock;
import org.starl.time.Time;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl deploy take}. */
@Command(
    name = "take",
    description =
        "Plays a take that Motive has exported as CSV, once, in place of a deployment's cameras: robots"
            + " get its poses as they got them in the session.",
    footer = {"", "Example: starl deploy take crossing.yaml session.csv"})
final class DeployTakeCommand extends BaseCommand implements Callable<Integer> {

  @Parameters(index = "0", paramLabel = "FILE", description = "A deployment file.")
  private String file = "";

  @Parameters(
      index = "1",
      paramLabel = "TAKE",
      description = "A take: CSV with rigid bodies, rotations as quaternions.")
  private Path take = Path.of("");

  @Option(
      names = "--hold",
      paramLabel = "TIME",
      defaultValue = "3s",
      description =
          "So long all bodies stand at their first places before the take, so that robots find theirs"
              + " (default: ${DEFAULT-VALUE}).")
  private String hold = "3s";

  /** Reasons to end; the empty string if the user stopped it. */
  private final BlockingQueue<String> ends = new LinkedBlockingQueue<>();

  @Override
  public Integer call() throws Exception {
    long holdNs = OptionValues.read("--hold", hold, Quantities::durationNs);
    Deployment deployment = DeploymentFile.read(file);
    Take played = Take.read(take, axes(deployment));
    List<RobotEntry> robots = List.copyOf(deployment.robots().values());
    List<Long> tracked = robots.stream().map(each -> played.tracked(each.rigidBody())).toList();
    if (tracked.stream().allMatch(count -> count == 0)) {
      throw new BadInput(
          take + ": tracks no robot of " + file + "; it has the rigid bodies " + played.names());
    }
    int frames = played.frames().size();
    for (int i = 0; i < robots.size(); i++) {
      out()
          .println(
              robots.get(i).id() + ": tracked in " + tracked.get(i) + " of " + frames + " frames");
    }
    stop().calls(() -> ends.add(""));
    return play(deployment, played, holdNs);
  }

  private int play(Deployment deployment, Take played, long holdNs) throws Exception {
    RealClock clock = RealClock.ofDate();
    long startNs = clock.nowNs() + holdNs;
    AutoCloseable cameras =
        open(deployment, played.from(startNs, clock), played.framesPerS(), clock);
    try {
      out()
          .println(
              "plays %s s at %s frames a second, after %s"
                  .formatted(
                      played.lengthNs() / (double) Time.NS_PER_S, played.framesPerS(), hold));
      out().flush();
      String reason = ends.poll(holdNs + played.lengthNs(), TimeUnit.NANOSECONDS);
      if (reason != null && !reason.isEmpty()) {
        err().println("starl: the take ended early: " + reason);
        return ExitStatus.VIOLATED;
      }
      out().println(reason == null ? "the take has ended" : "stopped before the end of the take");
      return ExitStatus.GOOD;
    } finally {
      cameras.close();
    }
  }

  private AutoCloseable open(
      Deployment deployment, PoseSource source, int framesPerS, RealClock clock) {
    try {
      return Cameras.open(
          deployment,
          source,
          framesPerS,
          clock,
          error -> ends.add(String.valueOf(error)),
          err()::println);
    } catch (IOException e) {
      throw new MissingDependencyException(FailureText.of(e));
    }
  }

  private static Axes axes(Deployment deployment) {
    return switch (deployment.positions()) {
      case Positions.NatNet natNet -> PoseFeeds.axes(natNet);
      case Positions.JsonFeed json -> Axes.DEFAULT;
      case Positions.Ros2 ros2 ->
          throw new BadInput(
              deployment.where("positions")
                  + "positions: source is ros2; expected optitrack or json, which a take can stand in for");
    };
  }
}
