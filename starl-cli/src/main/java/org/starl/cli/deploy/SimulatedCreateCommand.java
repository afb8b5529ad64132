package org.starl.cli.deploy;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.MissingDependencyException;
import org.starl.cli.command.OptionValues;
import org.starl.robot.create.CreateBody;
import org.starl.robot.create.CreateHost;
import org.starl.robot.create.CreateModel;
import org.starl.robot.create.StreamLink;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.serial.PseudoTerminal;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code starl simulated-create}. */
@Command(
    name = "simulated-create",
    description =
        "Simulates an iRobot Create on an open floor, at a serial port (Linux, macOS) or a TCP"
            + " port, until it is stopped. Prints each change of its wheel speeds.",
    footer = {"", "Example: starl simulated-create --pty create0"})
public final class SimulatedCreateCommand extends BaseCommand implements Runnable {

  private static final int MAX_PORT = 65_535;

  /** The port of the simulated robot. */
  private static final class Line {
    @Option(
        names = "--pty",
        paramLabel = "NAME",
        required = true,
        description = "Name of the serial port to create.")
    private @Nullable String pty;

    @Option(
        names = "--tcp",
        paramLabel = "[HOST:]PORT",
        required = true,
        description =
            "Port to listen on, 0 for any free one, at the address of HOST (default: 127.0.0.1). Any"
                + " computer that reaches it can drive the robot.")
    private String tcp = "";
  }

  @ArgGroup(multiplicity = "1")
  private @Nullable Line line;

  @Option(
      names = "--model",
      paramLabel = "MODEL",
      defaultValue = "CREATE_2",
      description = "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
  private CreateModel model = CreateModel.CREATE_2;

  @Override
  public void run() {
    PrintWriter out = out();
    Line port = Objects.requireNonNull(line);
    try (CreateHost host =
        CreateHost.start(
            "create",
            model,
            new OpenFloor(out),
            new RealClock(),
            end -> out.println("line ended: " + end.getMessage()))) {
      out.println(model + " at " + open(host, port));
      out.flush();
      Thread.currentThread().join();
    } catch (IOException e) {
      throw new MissingDependencyException("the port cannot be opened: " + e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static String open(CreateHost host, Line line) throws IOException {
    if (line.pty != null) {
      StreamLink terminal = PseudoTerminal.open(line.pty);
      host.serve(terminal);
      return terminal.name();
    }
    int colon = line.tcp.lastIndexOf(':');
    int port = OptionValues.whole("--tcp", line.tcp.substring(colon + 1), 0, MAX_PORT);
    InetAddress at =
        colon < 0
            ? InetAddress.getLoopbackAddress()
            : InetAddress.getByName(line.tcp.substring(0, colon));
    ServerSocket server = new ServerSocket(port, 1, at);
    host.listen(server);
    return "port " + server.getLocalPort();
  }

  /** A floor without obstacles; prints each change of the wheels. */
  private static final class OpenFloor implements CreateBody {
    private final PrintWriter out;
    private String last = "";

    OpenFloor(PrintWriter out) {
      this.out = out;
    }

    @Override
    public void drive(double leftMmPerS, double rightMmPerS, long atNs) {
      String now = "wheels: left " + leftMmPerS + ", right " + rightMmPerS + " mm/s";
      if (!now.equals(last)) {
        last = now;
        out.println(now);
        out.flush();
      }
    }

    @Override
    public Senses senses(long atNs) {
      return Senses.NOTHING;
    }
  }
}
