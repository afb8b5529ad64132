package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.robolectric.Shadows.shadowOf;

import android.app.Application;
import android.bluetooth.BluetoothAdapter;
import android.os.IBinder;
import android.os.Parcel;
import android.os.RemoteException;
import java.io.IOException;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ServiceController;
import org.robolectric.annotation.Config;
import org.starl.geometry.Pose;
import org.starl.robot.realtime.RealClock;

/** The service that guards the wheels, through its binder, with a simulated Create behind its socket. */
@RunWith(RobolectricTestRunner.class)
@Category(TakesLong.class)
@Config(
    sdk = 37,
    shadows = {AdapterShadow.class, SocketShadow.class, BinderShadow.class})
public final class WheelsServiceTest {

  private static final byte[] START_SAFE = {(byte) 128, (byte) 131};
  private static final byte[] SPEEDS = {(byte) 145, 0, 100, 0, 100};
  private static final long SECOND_NS = 1_000_000_000;

  /** A command is valid for longer than a test takes. */
  private static final long ALWAYS_MS = 1_000_000;

  private final RealClock clock = new RealClock();
  private final SimulatedCar car = new SimulatedCar("bot0", new Pose(0, 0, 0), clock, event -> {});
  private final List<SocketShadow> sockets = new CopyOnWriteArrayList<>();
  private final Application application = RuntimeEnvironment.getApplication();
  private final ServiceController<WheelsService> controller =
      Robolectric.buildService(WheelsService.class).create();
  private final Client client = new Client();
  private volatile IOException refusal;

  /** The robot's process. */
  private static final class Client extends GuardCalls.Receiver {
    volatile IBinder line;
    volatile String end;

    @Override
    void receive(int code, Parcel call) {
      if (code == GuardCalls.OPENED) {
        line = call.readStrongBinder();
      } else if (code == GuardCalls.ENDED) {
        end = call.readString();
      }
    }

    void write(long sentNs, byte[] bytes) throws RemoteException {
      GuardCalls.send(
          line,
          GuardCalls.WRITE,
          call -> {
            call.writeLong(sentNs);
            call.writeByteArray(bytes);
          });
    }
  }

  @Before
  public void pair() {
    BluetoothAdapter adapter = BluetoothLinks.adapter(application);
    shadowOf(adapter).setEnabled(true);
    shadowOf(adapter).setBondedDevices(Set.of(adapter.getRemoteDevice("00:06:66:12:34:56")));
    AdapterShadow.serve(
        (address, socket) -> {
          if (refusal != null) {
            throw refusal;
          }
          sockets.add(socket);
          car.serve(socket.getOutputStreamSink(), socket.getInputStreamFeeder());
        },
        service -> {});
  }

  @After
  public void endAll() {
    controller.destroy();
    car.close();
  }

  private void open(long validMs) throws RemoteException, InterruptedException {
    GuardCalls.send(
        controller.get().onBind(null),
        GuardCalls.OPEN,
        call -> {
          call.writeStrongBinder(client);
          call.writeString(SerialPorts.BLUETOOTH + AdapterShadow.NAME);
          call.writeLong(validMs);
        });
    car.until(() -> client.line != null || client.end != null);
  }

  private void drive() throws RemoteException, InterruptedException {
    client.write(RealClock.machineNs(), START_SAFE);
    client.write(RealClock.machineNs(), SPEEDS);
    car.until(car::turnsItsWheels);
  }

  @Test
  public void theWheelsStandWhenTheRobotsProcessIsSilent() throws Exception {
    open(200);
    for (int i = 0; i < 2; i++) {
      drive();
      car.until(() -> !car.turnsItsWheels());
    }
    assertThat(client.end).isNull();
  }

  @Test
  public void theWheelsStandAndTheLinkIsClosedWhenTheRobotsProcessDies() throws Exception {
    open(ALWAYS_MS);
    drive();
    BinderShadow.tellDeath(client);
    car.until(() -> !car.turnsItsWheels());
    assertThat(sockets).hasSize(1).allMatch(SocketShadow::isClosed);
  }

  @Test
  public void theWheelsStandWhenTheRobotClosesItsLink() throws Exception {
    open(ALWAYS_MS);
    drive();
    GuardCalls.send(client.line, GuardCalls.CLOSE, call -> {});
    car.until(() -> client.end != null && !car.turnsItsWheels());
    client.write(RealClock.machineNs(), SPEEDS);
    assertThat(sockets).allMatch(SocketShadow::isClosed);
  }

  @Test
  public void speedsBehindAStallAreDroppedAndTheWheelsStopInstead() throws Exception {
    open(ALWAYS_MS);
    drive();
    client.write(RealClock.machineNs() - 2 * ALWAYS_MS * SECOND_NS / 1000, SPEEDS);
    car.until(() -> !car.turnsItsWheels());
    drive();
  }

  @Test
  public void aRobotThatDiedBeforeItsLinkWasOpenDrivesNoWheel() throws Exception {
    BinderShadow.tellDeath(client);
    GuardCalls.send(
        controller.get().onBind(null),
        GuardCalls.OPEN,
        call -> {
          call.writeStrongBinder(client);
          call.writeString(SerialPorts.BLUETOOTH + AdapterShadow.NAME);
          call.writeLong(ALWAYS_MS);
        });
    car.until(() -> !sockets.isEmpty() && sockets.get(0).isClosed());
    assertThat(client.line).isNull();
  }

  @Test
  public void aPortThatCannotBeOpenedIsToldWithItsReason() throws Exception {
    refusal = new IOException("read failed, socket might closed or timeout");
    open(200);
    assertThat(client.line).isNull();
    assertThat(client.end).isEqualTo("read failed, socket might closed or timeout");
  }
}
