package org.starl.cli.serve;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.ServiceLoader;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.cli.campaign.Ending;
import org.starl.cli.campaign.SeedWork;
import org.starl.cli.campaign.ShardWork;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.Carriers;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.MissingDependencyException;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.ProgressLine;
import org.starl.cli.command.Shell;
import org.starl.cli.command.ThreadsOption;
import org.starl.cli.request.RunOptions;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.SeedOption;
import org.starl.cli.request.Seeds;
import org.starl.cli.request.TraceFile;
import org.starl.cli.run.ProcessOptions;
import org.starl.cli.run.ProcessOutcome;
import org.starl.cli.run.Viewing;
import org.starl.input.BadInput;
import org.starl.launch.LiveMerge;
import org.starl.launch.LiveTraces;
import org.starl.sim.SimulationPlan;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.replay.Recording;
import org.starl.sim.replay.TraceLoader;
import org.starl.sim.view.page.LivePage;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl serve}. */
@Command(
    name = "serve",
    description =
        "Shows a run in a browser while it goes on: a simulation, robots as processes, a deployment,"
            + " a trace, or the runs of a campaign. Without an app, a playground. Ends with Ctrl-C.",
    footer = {
      "",
      "Example: starl serve intersection --seed 7",
      "         starl serve intersection --processes --kill bot2@12s",
      "         starl serve --deployed out",
      "         starl serve mutex --seeds 1..200 --chaos",
      "         starl serve out/crossing.trace",
      "         starl serve"
    })
public final class ServeCommand extends BaseCommand implements Callable<Integer> {

  private static final Pattern ORIGIN = Pattern.compile("https?://[^/\\s]+");
  private static final int TOKEN_BYTES = 16;
  private static final int MOST_PORT = 65_535;

  @Mixin private RunOptions options = new RunOptions();

  @Parameters(
      index = "0",
      arity = "0..1",
      paramLabel = "APP|PRIMITIVE|FILE.yaml|TRACE",
      description = "An app, a primitive, a scenario file or a trace (default: a playground).")
  void app(@Nullable String text) {
    options.named(text == null ? "" : text);
  }

  @Mixin private SeedOption seed = new SeedOption();

  @Mixin private ProcessOptions processes = new ProcessOptions();

  @Mixin private ThreadsOption threads = new ThreadsOption();

  @Option(
      names = "--seeds",
      paramLabel = "A..B",
      description = "Show a campaign of these seeds; a bad run opens with a click.")
  private @Nullable String seeds;

  @Option(
      names = "--deployed",
      paramLabel = "DIR",
      description =
          "Show the robots of a deployment whose traces are in DIR, the --folder of 'deploy run'."
              + " Only reads.")
  private @Nullable String deployed;

  @Option(
      names = "--port",
      paramLabel = "N",
      defaultValue = "8080",
      description = "Port; 0 for any that is free (default: ${DEFAULT-VALUE}).")
  private String port = "8080";

  @Option(
      names = "--host",
      paramLabel = "HOST",
      defaultValue = "127.0.0.1",
      description =
          "Address to listen at (default: ${DEFAULT-VALUE}). Beyond this machine each browser needs"
              + " the token that is printed.")
  private String host = "127.0.0.1";

  @Option(
      names = "--origin",
      paramLabel = "URL",
      description =
          "Also let pages of URL connect, such as https://app.foxglove.dev. May be repeated.")
  private List<String> origins = new ArrayList<>();

  /** Work on the calling thread, while the server runs. */
  private interface Work {
    void run() throws IOException, InterruptedException;
  }

  @Override
  public Integer call() throws IOException {
    PageServer.Access access =
        new PageServer.Access(
            host, OptionValues.whole("--port", port, 0, MOST_PORT), token(), origins());
    CarrierKind carriers = Carriers.select(null, err());
    try (LiveSite site = new LiveSite(demos(), home(), carriers)) {
      Work work = prepare(site, carriers);
      stop().calls(Thread.currentThread()::interrupt);
      try (PageServer.Running server = server().start(access, site)) {
        List<String> addresses = addresses(access, server.port());
        out().println(addresses.getFirst() + " (Ctrl-C ends it)");
        addresses.subList(1, addresses.size()).forEach(out()::println);
        work.run();
        site.await();
      } catch (InterruptedException e) {
        err().println("stopped");
      } finally {
        stop().endsWhenAsked();
      }
    }
    return ExitStatus.GOOD;
  }

  private static PageServer server() {
    return ServiceLoader.load(PageServer.class)
        .findFirst()
        .orElseThrow(() ->
            new MissingDependencyException(
                "serve: the server is not on the class path; expected './starl serve', which adds"
                    + " it, or the library org.starl:starl-cli-serve"));
  }

  private List<String> origins() {
    for (String origin : origins) {
      if (!ORIGIN.matcher(origin).matches()) {
        throw new BadInput(
            "--origin: " + BadInput.quote(origin) + ": expected https://HOST, without a path");
      }
    }
    return origins;
  }

  /** Empty if only this machine can connect. */
  private String token() {
    try {
      if (InetAddress.getByName(host).isLoopbackAddress()) {
        return "";
      }
    } catch (UnknownHostException e) {
      throw new BadInput("--host: " + BadInput.quote(host) + ": expected an address or a name");
    }
    byte[] secret = new byte[TOKEN_BYTES];
    new SecureRandom().nextBytes(secret);
    return HexFormat.of().formatHex(secret);
  }

  /** For browsers: where the server listens at all addresses, those of this machine. */
  private static List<String> addresses(PageServer.Access access, int port) throws IOException {
    List<String> hosts = new ArrayList<>(List.of(access.host()));
    if (InetAddress.getByName(access.host()).isAnyLocalAddress()) {
      hosts.clear();
      NetworkInterface.networkInterfaces()
          .flatMap(NetworkInterface::inetAddresses)
          .filter(each -> each instanceof Inet4Address)
          .sorted(Comparator.comparing(InetAddress::isLoopbackAddress))
          .forEach(each -> hosts.add(each.getHostAddress()));
    }
    String token = access.token().isEmpty() ? "" : "?token=" + access.token();
    return hosts.stream()
        .map(host -> host.contains(":") ? "[" + host + "]" : host)
        .map(host -> "http://" + host + ":" + port + "/" + token)
        .toList();
  }

  private Site.Home home() {
    if (seeds != null) {
      return Site.Home.CAMPAIGN;
    }
    return options.name().isEmpty() && deployed == null ? Site.Home.PLAYGROUND : Site.Home.RUN;
  }

  /** Checks the options, and adds what the site shows. */
  private Work prepare(LiveSite site, CarrierKind carriers) {
    String[] kinds =
        OptionValues.given(
            "--deployed", deployed, "--processes", processes.areOn(), "--seeds", seeds);
    if (kinds.length > 1) {
      throw new BadInput(kinds[1] + " cannot be used with " + kinds[0]);
    }
    if (deployed != null) {
      if (!options.name().isEmpty()) {
        throw new BadInput(options.name() + ": expected no app with --deployed");
      }
      requireNoOption("--deployed");
      return deployment(site, deployed);
    }
    if (options.name().isEmpty()) {
      requireNoOption("a playground");
      if (kinds.length > 0) {
        throw new BadInput(kinds[0] + " needs an app; expected 'starl serve APP " + kinds[0] + "'");
      }
      return () -> {};
    }
    if (TraceFile.isTrace(options.name())) {
      if (kinds.length > 0) {
        throw new BadInput(kinds[0] + " cannot be used with a trace: " + options.name());
      }
      requireNoOption(options.name());
      return trace(site);
    }
    return seeds == null ? run(site) : campaign(site, Seeds.Range.of(seeds), carriers);
  }

  private void requireNoOption(String what) {
    options.requireNoneFor(what);
    seed.requireNoneFor(what);
  }

  private Work run(LiveSite site) {
    RunRequest request = options.request(demos());
    long seedNumber = seed.value();
    Plan plan = request.plan(seedNumber);
    request.unusedRobots(seedNumber).ifPresent(err()::println);
    if (!processes.areOn()) {
      plan.simulation().build();
      site.start(request, seedNumber, request.plan(seedNumber), true);
      return () -> {};
    }
    String again = processes.again(request.replay(seedNumber));
    SimulationPlan simulation = plan.simulation().commands(() -> List.of(again)).build().plan();
    Recording recording = Viewing.recording(plan);
    String title = request.demo().name() + ", seed " + seedNumber;
    String command = request.replay(seedNumber) + processes.replay();
    site.add(new Site.Shown(title, command, recording, new LivePage(recording, 1)));
    return () -> {
      LiveMerge live = new LiveMerge(simulation, List.of(recording));
      try {
        ProcessOutcome.lines(
                processes.run(
                    simulation,
                    request.words(seedNumber),
                    request.vocabulary(seedNumber),
                    live,
                    err()))
            .forEach(out()::println);
        recording.over(live.end());
      } catch (IOException | RuntimeException e) {
        if (e.getCause() instanceof InterruptedException stopped) {
          throw stopped; // the normal end of a command that goes on until it is stopped
        }
        recording.failed(String.valueOf(e.getMessage()));
        throw e;
      }
    };
  }

  private Work trace(LiveSite site) {
    TraceFile trace = TraceFile.open(options.name(), demos());
    TraceLoader reading = trace.reading();
    String title = trace.header().scenario() + ", seed " + trace.header().scenarioSeed();
    Recording recording = reading.recording();
    site.add(new Site.Shown(title, "", recording, new LivePage(recording, 0)));
    return () -> {
      try (reading) {
        reading.start();
        site.await();
      }
    };
  }

  private Work deployment(LiveSite site, String name) {
    Path folder = Path.of(name);
    TraceFile first = TraceFile.open(LiveTraces.any(folder), demos());
    Plan plan = first.plan();
    String check = "check: " + Shell.starl(List.of("deploy", "merge")) + " " + Shell.quote(name);
    SimulationPlan simulation =
        plan.simulation().commands(() -> List.of(check + "/*.trace")).build().plan();
    Recording recording = Viewing.recording(plan);
    LiveMerge merge = new LiveMerge(simulation, List.of(recording));
    LiveTraces traces =
        new LiveTraces(
            folder,
            header -> TraceFile.vocabulary(first.name(), header, demos()),
            first.header(),
            merge,
            err()::println);
    String title = first.header().scenario() + ", " + name;
    site.add(new Site.Shown(title, "", recording, new LivePage(recording, 1)));
    return () -> {
      try (traces) {
        site.await();
      }
    };
  }

  private Work campaign(LiveSite site, Seeds.Range range, CarrierKind carriers) {
    seed.requireNoneFor("--seeds " + range);
    RunRequest request = options.request(demos());
    SeedWork work = SeedWork.campaign(request, range, Ending.of(false, "", range));
    request.plan(range.first()).simulation().build();
    site.begin(request, range.size());
    int workers = threads.count();
    return () -> {
      ProgressLine progress = new ProgressLine(err(), "runs");
      work.runSeeds(
          range,
          new ShardWork.How(carriers, workers, progress),
          false,
          row -> {
            site.add(row);
            return false;
          });
      progress.end();
      site.endCampaign();
    };
  }
}
