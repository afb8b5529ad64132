package org.starl.build;

import java.util.List;

/**
 * A place where a rule does not hold, with the reason. This is the one list of them; one that
 * nothing needs any more fails the test.
 *
 * @param path a file, or a folder that ends with a slash
 */
record Allowance(String rule, String path, String reason) {

  private static final String MAIN = "/src/main/java/org/starl/";
  private static final String KERNEL = "starl-sim" + MAIN + "sim/kernel/";
  private static final String VIEW = "starl-sim/view" + MAIN + "sim/view/";
  private static final String BUILD_TESTS = "starl-cli/src/test/java/org/starl/build/";

  static List<Allowance> all() {
    return List.of(
        new Allowance(
            "wall clock",
            "starl-android/robot" + MAIN + "robot/realtime/RealClock.java",
            "it is the platform's clock"),
        new Allowance(
            "wall clock",
            "starl-cli/bench" + MAIN + "bench/Measurement.java",
            "a benchmark measures the machine, and decides nothing by it"),
        new Allowance(
            "wall clock",
            KERNEL + "BoundedWait.java",
            "how long to wait for an app that blocks outside the kernel, before the run fails"),
        new Allowance(
            "wall clock",
            "starl-cli" + MAIN + "cli/command/ProgressLine.java",
            "tells a person how long a campaign will take"),
        new Allowance(
            "wall clock",
            "starl-cli" + MAIN + "cli/campaign/CiCommand.java",
            "a person says how long it may take: how many seeds run depends on it, no run does"),
        new Allowance(
            "wall clock",
            VIEW + "Window.java",
            "a person watches in real time; it decides nothing in the run"),
        new Allowance(
            "wall clock",
            VIEW + "ViewBench.java",
            "a benchmark measures the machine, and decides nothing by it"),
        new Allowance(
            "threads and locks where one strand runs at a time",
            "starl-core" + MAIN + "comms/Spare.java",
            "a spare object for all robots of a process, whose strands may run at once"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-lang" + MAIN + "lang/server/",
            "an editor is answered in futures, as the protocol's library has it"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            VIEW + "Window.java",
            "who opens it waits, off Swing's thread, until it is closed"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            VIEW + "Interventions.java",
            "what came of them comes from the run's thread"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            KERNEL,
            "carriers run blocking apps, one at a time"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-sim" + MAIN + "sim/GuardedRun.java",
            "a run has a thread of its own, so that its caller can give it up"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli/spark" + MAIN + "spark/PartsJob.java",
            "results come from the threads of Spark"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-sim" + MAIN + "sim/check/Campaign.java",
            "whole runs side by side, none sharing state with another"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-sim/view" + MAIN + "sim/replay/",
            "a recording is filled by its run's thread and read by who watches"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-sim" + MAIN + "sim/explore/Explorer.java",
            "collects the orders of runs on several threads"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-sim" + MAIN + "sim/junit/SeededRuns.java",
            "explored runs are planned on several threads, by one at a time"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli" + MAIN + "cli/campaign/SeedRuns.java",
            "collects the rows of runs on several threads"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli" + MAIN + "cli/campaign/SplitRuns.java",
            "collects the estimates of seeds on several threads"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli/launch" + MAIN + "launch/",
            "pipes, sockets and robots in real time"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli" + MAIN + "cli/command/ProgressLine.java",
            "a signal asks from another thread how far the work is"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli" + MAIN + "cli/mutants/BugProcess.java",
            "a bug may never end: after a time, its process is ended"),
        new Allowance(
            "wall clock",
            "starl-cli" + MAIN + "cli/mutants/BugWorker.java",
            "tells how long runs without a bug take; only bugs that never end depend on it"),
        new Allowance(
            "writing to the console",
            "starl-cli" + MAIN + "cli/mutants/BugWorker.java",
            "the standard output of the second process is for its answers"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli" + MAIN + "cli/command/UntilStopped.java",
            "the process is stopped from outside, and its wheels first"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-sim/view" + MAIN + "sim/view/page/LivePage.java",
            "browsers take its parts on threads of their own"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli" + MAIN + "cli/serve/LiveSite.java",
            "browsers start and read runs on threads of their own"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli/serve" + MAIN + "serve/",
            "each connection has a thread, which reads what is recorded"),
        new Allowance(
            "randomness without the run's seed",
            "starl-cli" + MAIN + "cli/serve/ServeCommand.java",
            "a token that a seed decides is no secret"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli" + MAIN + "cli/deploy/DeployTakeCommand.java",
            "the cameras' thread, or a signal, ends the wait for the take's end"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli" + MAIN + "cli/deploy/DeployWorldCommand.java",
            "robots that run beside their world"),
        new Allowance(
            "writing to the console",
            "starl-cli" + MAIN + "cli/Main.java",
            "where the command line's two writers are made"),
        new Allowance(
            "writing to the console",
            "starl-android/apk" + MAIN + "android/apk/Main.java",
            "where that command's two writers are made"),
        new Allowance(
            "writing to the console",
            "starl-cli" + MAIN + "cli/project/LauncherBuild.java",
            "the launcher's own main class"),
        new Allowance(
            "threads and locks in the simulator and its tools",
            "starl-cli" + MAIN + "cli/project/LauncherBuild.java",
            "Maven ends when the launcher is told to end"),
        new Allowance(
            "randomness without the run's seed",
            "starl-cli" + MAIN + "cli/request/Seeds.java",
            "draws a run's seed when none is given; it is printed"),
        new Allowance(
            "randomness without the run's seed",
            "starl-android/robot" + MAIN + "robot/udp/KeyFile.java",
            "a key that a seed decides is no secret"),
        new Allowance(
            "randomness without the run's seed",
            "starl-android/robot" + MAIN + "robot/udp/Discovery.java",
            "a nonce that a seed decides proves nothing"),
        hash("starl-core" + MAIN + "comms/InboundWindows.java"),
        hash("starl-core" + MAIN + "comms/Seal.java"),
        hash("starl-core" + MAIN + "trace/EventParser.java"),
        hash("starl-primitives" + MAIN + "primitives/geocast/GeocastProtocol.java"),
        hash("starl-sim" + MAIN + "sim/net/Partition.java"),
        hash("starl-sim" + MAIN + "sim/world/Placement.java"),
        new Allowance("a reminder of work that is left", BUILD_TESTS, "names what it forbids"),
        new Allowance("a path of somebody's machine", BUILD_TESTS, "names what it forbids"),
        new Allowance("a registry's host", BUILD_TESTS, "names what it forbids"),
        new Allowance(
            "a registry's host",
            ".mvn/wrapper/maven-wrapper.properties",
            "the wrapper has no default of its own; MVNW_REPOURL and Maven's settings replace it"),
        new Allowance("words about how the project is made", BUILD_TESTS, "names what it forbids"));
  }

  private static Allowance hash(String path) {
    return new Allowance(
        "a collection in hash order", path, "only looked up by key, never gone through in order");
  }

  boolean covers(Rule.Finding finding) {
    return finding.rule().name().equals(rule)
        && (path.endsWith("/") ? finding.path().startsWith(path) : finding.path().equals(path));
  }
}
