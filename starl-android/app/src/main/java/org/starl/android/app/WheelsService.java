package org.starl.android.app;

import android.app.Service;
import android.content.Intent;
import android.os.IBinder;
import android.os.Parcel;
import android.os.Process;
import android.os.RemoteException;
import android.util.Log;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.WheelGuard;
import org.starl.robot.file.Wheels.Port;
import org.starl.robot.realtime.Daemons;

/**
 * The process that guards the wheels: the manifest gives this service a process of its own, which has
 * the link to the Create. A {@link WheelGuard} stops the wheels when the robot's process dies, which
 * Android tells, or when it sends no valid command in time.
 */
public final class WheelsService extends Service {

  private static final String TAG = "StarL wheels";

  private final GuardCalls.Receiver calls =
      new GuardCalls.Receiver() {
        @Override
        void receive(int code, Parcel call) {
          if (code == GuardCalls.OPEN) {
            IBinder client = call.readStrongBinder();
            Port port = Objects.requireNonNull(Port.parse(String.valueOf(call.readString())));
            new Line(client, port, call.readLong()).start();
          }
        }
      };

  @Override
  public IBinder onBind(Intent intent) {
    return calls;
  }

  /** One link, with its guard. */
  private final class Line extends GuardCalls.Receiver {
    private final IBinder client;
    private final Port port;
    private final long validMs;
    private volatile @Nullable WheelGuard guard;

    Line(IBinder client, Port port, long validMs) {
      this.client = client;
      this.port = port;
      this.validMs = validMs;
    }

    // Opening blocks, so this has a thread of its own, which then reads.
    void start() {
      Daemons.of("wheels", this::run).start();
    }

    @Override
    void receive(int code, Parcel call) {
      WheelGuard here = guard;
      if (here == null) {
        return; // it is not open yet
      }
      if (code == GuardCalls.WRITE) {
        long sentNs = call.readLong();
        byte[] bytes = call.createByteArray();
        here.pass(sentNs, bytes == null ? new byte[0] : bytes);
      } else if (code == GuardCalls.CLOSE) {
        here.close();
      }
    }

    private void run() {
      String reason;
      try {
        ByteLink link = SerialPorts.at(getApplicationContext(), port).open();
        WheelGuard opened = WheelGuard.start(link, validMs);
        guard = opened;
        reason = guarded(opened);
        opened.close();
      } catch (IOException e) {
        reason = String.valueOf(e.getMessage());
      }
      tellEnd(reason);
    }

    private String guarded(WheelGuard opened) {
      IBinder.DeathRecipient death = opened::close;
      try {
        client.linkToDeath(death, 0);
        GuardCalls.send(
            client,
            GuardCalls.OPENED,
            call -> {
              call.writeStrongBinder(this);
              call.writeInt(Process.myPid());
            });
      } catch (RemoteException e) {
        return "the robot's process has ended";
      }
      String reason = opened.passToProgram(new ToClient(client));
      client.unlinkToDeath(death, 0);
      return reason;
    }

    private void tellEnd(String reason) {
      try {
        GuardCalls.send(client, GuardCalls.ENDED, call -> call.writeString(reason));
      } catch (RemoteException e) {
        Log.w(TAG, "the robot's process has ended: wheels stopped", e);
      }
    }
  }

  /** Bytes of the Create on their way to the robot's process. */
  private static final class ToClient extends OutputStream {
    private final IBinder client;

    ToClient(IBinder client) {
      this.client = client;
    }

    @Override
    public void write(int value) throws IOException {
      write(new byte[] {(byte) value}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
      byte[] row = Arrays.copyOfRange(bytes, offset, offset + length);
      try {
        GuardCalls.send(client, GuardCalls.READ, call -> call.writeByteArray(row));
      } catch (RemoteException e) {
        throw new IOException("the robot's process takes no bytes", e);
      }
    }
  }
}
