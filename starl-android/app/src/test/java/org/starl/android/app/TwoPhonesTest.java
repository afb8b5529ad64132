package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.robolectric.Shadows.shadowOf;

import android.Manifest;
import android.app.Application;
import android.bluetooth.BluetoothAdapter;
import android.content.ComponentName;
import android.content.Intent;
import android.os.Looper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.annotation.Config;
import org.starl.Version;
import org.starl.android.app.RobotService.Phase;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.launch.TraceMerge;
import org.starl.robot.DeployedRobot;
import org.starl.robot.optitrack.NatNetServer;
import org.starl.robot.optitrack.PoseSource;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.trace.LateTrace;
import org.starl.robot.trace.MachineClock;
import org.starl.robot.trace.ProcessTrace;
import org.starl.robot.udp.KeyFile;
import org.starl.sim.SimulationPlan;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceHeader;
import org.starl.trace.Vocabulary;

/**
 * Two phones cross the paper's intersection: two services in one process, each a robot of the same
 * deployment, with a Create of its own behind its Bluetooth socket, over real datagrams on the loopback
 * interface.
 */
@RunWith(RobolectricTestRunner.class)
@Category(TakesLong.class)
@Config(
    sdk = 37,
    shadows = {AdapterShadow.class, SocketShadow.class})
public final class TwoPhonesTest {

  private static final List<String> NAMES = List.of("bot0", "bot1");

  /** Two Creates that touch. */
  private static final double TOUCH_MM = 330;

  private static final long SEED = 7;
  private static final long CLOCK_ERROR_NS = 1_000_000_000;
  private static final long DRIFT_PPM = 100;

  @Rule public final TemporaryFolder folder = new TemporaryFolder();

  private final RealClock clock = RealClock.ofDate();
  private final long startNs = clock.nowNs();
  private final Application application = RuntimeEnvironment.getApplication();
  private final IntersectionDemo demo = new IntersectionDemo();
  private final Request figure7 = figure7(demo);
  private final Plan plan = demo.plan(figure7, demo.defaultSettings(figure7).build());
  private final SimulationPlan crossing = plan.simulation().build().plan();
  private final SortedMap<String, SimulatedCar> cars = new TreeMap<>();
  private final List<ServiceController<RobotService>> phones = new ArrayList<>();
  private NatNetServer cameras;
  private Path worldsTrace;
  private ProcessTrace world;

  private static Request figure7(IntersectionDemo demo) {
    SortedMap<String, String> parameters = demo.defaults();
    parameters.put("scenario", "figure7");
    parameters.put("debris", "0");
    return new Request(SEED, OptionalInt.empty(), parameters);
  }

  /** As that of the phones' traces. */
  private static TraceHeader header() {
    return new TraceHeader(
        Version.STARL,
        "intersection",
        SEED,
        TraceHeader.behaviourSeedOf(SEED),
        Map.of(),
        NAMES.stream().map(RobotId::new).toList());
  }

  private static String adapterOf(String robot) {
    return "00:06:66:00:00:0" + NAMES.indexOf(robot);
  }

  @Before
  public void pairAndPlace() throws IOException {
    shadowOf(application)
        .setComponentNameAndServiceForBindService(
            new ComponentName(application, WheelsService.class),
            Robolectric.buildService(WheelsService.class).create().get().onBind(new Intent()));
    shadowOf(application)
        .grantPermissions(Manifest.permission.BLUETOOTH_CONNECT, Permissions.ACCESS_LOCAL_NETWORK);
    BluetoothAdapter adapter = BluetoothLinks.adapter(application);
    shadowOf(adapter).setEnabled(true);
    shadowOf(adapter)
        .setBondedDevices(
            new HashSet<>(
                NAMES.stream().map(name -> adapter.getRemoteDevice(adapterOf(name))).toList()));
    worldsTrace = folder.getRoot().toPath().resolve("world.trace");
    world = new ProcessTrace(Fault.WORLD, header(), Files.newOutputStream(worldsTrace));
    MachineClock.tell(world, clock, startNs);
    LateTrace truth = new LateTrace(world, startNs, event -> {});
    for (int i = 0; i < NAMES.size(); i++) {
      String name = NAMES.get(i);
      Pose start = crossing.robots().get(i).start();
      cars.put(name, new SimulatedCar(name, start, clock, truth::record));
    }
    AdapterShadow.serve(
        (address, socket) -> {
          String robot =
              NAMES.stream()
                  .filter(name -> adapterOf(name).equals(address))
                  .findFirst()
                  .orElseThrow();
          cars.get(robot).serve(socket.getOutputStreamSink(), socket.getInputStreamFeeder());
        },
        service -> {});
    cameras =
        NatNetServer.open(
            SimulatedCar.CAMERAS,
            () -> {
              List<PoseSource.Body> bodies =
                  cars.values().stream().map(SimulatedCar::asSeen).toList();
              return new PoseSource.Snapshot(clock.nowNs(), bodies);
            },
            clock,
            failure -> {});
  }

  @After
  public void endAll() {
    phones.forEach(ServiceController::destroy);
    cameras.close();
    cars.values().forEach(SimulatedCar::close);
  }

  private void loadDeploymentAndKey() throws IOException {
    List<String> lines =
        new ArrayList<>(
            List.of(
                "app: intersection",
                "parameters: {scenario: figure7, debris: 0}",
                "seed: " + SEED,
                "key: crossing.key",
                "network: {broadcasts: no, loss: 0.1}",
                "positions: {source: natnet, server: \"127.0.0.1:"
                    + cameras.address().getPort()
                    + "\"}",
                "robots:"));
    List<DatagramSocket> free = new ArrayList<>();
    for (String name : NAMES) {
      DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
      free.add(socket);
      lines.add("  " + name + ":");
      lines.add("    address: \"127.0.0.1:" + socket.getLocalPort() + "\"");
      lines.add(
          "    chassis: {kind: create, model: create1, port: \"bluetooth:"
              + adapterOf(name)
              + "\"}");
    }
    free.forEach(DatagramSocket::close);
    Path key = folder.getRoot().toPath().resolve("crossing.key");
    KeyFile.generate(key);
    Store store = new Store(application);
    store.load(Store.Item.KEY, new ByteArrayInputStream(Files.readAllBytes(key)));
    byte[] deployment = String.join("\n", lines).getBytes(StandardCharsets.UTF_8);
    store.load(Store.Item.DEPLOYMENT, new ByteArrayInputStream(deployment));
  }

  /** Selects the phone of this robot; a service reads the selection when it starts. */
  private RobotService start(String robot) throws InterruptedException {
    new Store(application).setRobotName(robot);
    ServiceController<RobotService> controller =
        Robolectric.buildService(RobotService.class).create();
    phones.add(controller);
    RobotService phone = controller.get();
    phone.onStartCommand(RobotService.intent(application, RobotService.START), 0, 1);
    until(() -> phone.phase() != Phase.STARTING);
    assertThat(phone.problem()).isEmpty();
    assertThat(phone.status().robot().name()).isEqualTo(robot);
    return phone;
  }

  private void until(BooleanSupplier isSo) throws InterruptedException {
    cars.get(NAMES.get(0))
        .until(() -> {
          shadowOf(Looper.getMainLooper()).idle();
          return isSo.getAsBoolean();
        });
  }

  private double apartMm() {
    return cars.get("bot0").pose().at().distanceMm(cars.get("bot1").pose().at());
  }

  /** The unpacked traces that a person saves from the phone of this robot. */
  private List<String> savedTraces(String robot) throws IOException {
    ByteArrayOutputStream saved = new ByteArrayOutputStream();
    assertThat(new Store(application).saveTraces(robot, saved)).isEqualTo(1);
    List<String> files = new ArrayList<>();
    try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(saved.toByteArray()))) {
      for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
        Path file = folder.getRoot().toPath().resolve(entry.getName());
        Files.copy(zip, file);
        files.add(file.toString());
      }
    }
    return files;
  }

  @Test
  public void bothRobotsCrossAndTheirTracesSatisfyTheSpecifications()
      throws IOException, InterruptedException {
    loadDeploymentAndKey();
    List<RobotService> services = new ArrayList<>();
    for (String name : NAMES) {
      services.add(start(name));
    }
    until(() -> {
      assertThat(apartMm()).isGreaterThan(TOUCH_MM);
      return services.stream().allMatch(phone -> phone.status().appState().startsWith("has ended"));
    });
    assertThat(services)
        .allSatisfy(phone -> {
          assertThat(phone.status().bug()).isNull();
          assertThat(phone.status().radio().received()).isPositive();
        });
    for (RobotService phone : services) {
      phone.onStartCommand(RobotService.intent(application, RobotService.STOP), 0, 2);
      until(() -> phone.status() == null);
    }

    cars.values().forEach(SimulatedCar::close);
    world.end(clock.nowNs() - startNs);
    List<String> traces = new ArrayList<>();
    for (String name : NAMES) {
      traces.addAll(savedTraces(name));
    }
    assertThat(traces)
        .extracting(file -> Path.of(file).getFileName().toString())
        .isEqualTo(Arrays.asList("bot0.1.trace", "bot1.1.trace"));
    traces.add(worldsTrace.toString());
    Vocabulary vocabulary = demo.vocabulary(figure7).and(DeployedRobot.VOCABULARY);
    TraceMerge.Result result =
        TraceMerge.of(traces, header -> vocabulary, CLOCK_ERROR_NS, DRIFT_PPM)
            .judge(crossing, crossing.observers());
    assertThat(result.dead()).isEmpty();
    assertThat(result.violations()).isEmpty();
    assertThat(result.possible()).isEmpty();
    SpecReport spec = result.run().spec();
    assertThat(spec.lemmas().stream().mapToLong(spec::checks).sum()).isGreaterThan(100);
    for (String name : NAMES) {
      assertThat(plan.story().lines())
          .anySatisfy(line ->
              assertThat(line)
                  .startsWith(name + " (")
                  .contains("was registered", "was unregistered"));
    }
  }
}
