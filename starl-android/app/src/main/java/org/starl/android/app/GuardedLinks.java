package org.starl.android.app;

import android.content.ComponentName;
import android.content.Context;
import android.content.Intent;
import android.content.ServiceConnection;
import android.os.IBinder;
import android.os.Parcel;
import android.os.Process;
import android.os.RemoteException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.Guard;
import org.starl.robot.create.WheelGuard;
import org.starl.robot.file.Wheels.Port;
import org.starl.robot.realtime.RealClock;
import org.starl.time.Time;

/**
 * Links to a Create through the process of {@link WheelsService}; each link has a guard of its own. A
 * guard that is killed, or that does not close its link in time and is killed for it, has not stopped
 * the wheels: then this process does that, over a link of its own, before another guard opens one.
 */
final class GuardedLinks implements ByteLink.Source {

  /** A process starts, and Bluetooth connects or gives up. */
  private static final long OPEN_NS = 30 * Time.NS_PER_S;

  /** A guard that has not closed its link by then is frozen, or stuck in a write. */
  private static final long CLOSE_NS = Time.NS_PER_S;

  private static final String DEAD = "the process that guards the wheels has ended";
  private static final String SILENT = "the process that guards the wheels does not answer";

  private final Context context;
  private final Port port;
  private final long validMs;

  /**
   * @param validMs for how many ms the guard executes a command
   */
  GuardedLinks(Context context, Port port, long validMs) {
    this.context = context;
    this.port = port;
    this.validMs = validMs;
  }

  @Override
  public ByteLink open() throws IOException {
    GuardedLink link = new GuardedLink();
    try {
      link.open();
      return link;
    } catch (IOException e) {
      link.close();
      throw e;
    }
  }

  private final class GuardedLink implements ByteLink, ServiceConnection {
    private final Guard state = new Guard();
    private final Calls calls = new Calls();

    // Of the state.
    private final ArrayDeque<byte[]> received = new ArrayDeque<>();
    private @Nullable IBinder line;
    private int guardsPid;
    private @Nullable String endReason;
    private boolean isGuardDead;
    private boolean isClosed;

    /** Calls of the guard. */
    private final class Calls extends GuardCalls.Receiver {
      @Override
      void receive(int code, Parcel call) {
        if (code == GuardCalls.OPENED) {
          opened(call.readStrongBinder(), call.readInt());
        } else if (code == GuardCalls.READ) {
          byte[] bytes = call.createByteArray();
          change(() -> received.add(bytes == null ? new byte[0] : bytes));
        } else if (code == GuardCalls.ENDED) {
          ended(String.valueOf(call.readString()), false);
        }
      }
    }

    void open() throws IOException {
      Intent guard = new Intent(context, WheelsService.class);
      if (!context.bindService(guard, this, Context.BIND_AUTO_CREATE | Context.BIND_IMPORTANT)) {
        throw new IOException("Android does not start the process that guards the wheels");
      }
      state.await(() -> line != null || endReason != null, OPEN_NS);
      String problem = state.get(() -> line == null && endReason == null ? SILENT : endReason);
      if (problem != null) {
        throw new IOException(problem);
      }
    }

    // On the main thread.
    @Override
    public void onServiceConnected(ComponentName name, IBinder service) {
      try {
        GuardCalls.send(
            service,
            GuardCalls.OPEN,
            call -> {
              call.writeStrongBinder(calls);
              call.writeString(port.toString());
              call.writeLong(validMs);
            });
      } catch (RemoteException e) {
        ended(DEAD, true);
      }
    }

    // On the main thread.
    @Override
    public void onServiceDisconnected(ComponentName name) {
      ended(DEAD, true);
    }

    private void opened(IBinder newLine, int pid) {
      change(() -> {
        line = newLine;
        guardsPid = pid;
      });
      if (state.get(() -> isClosed)) {
        sendClose(); // it has opened too late
      }
    }

    private void ended(String reason, boolean isDead) {
      change(() -> {
        if (endReason == null) {
          endReason = reason;
          isGuardDead = isDead;
        }
      });
    }

    @Override
    public InputStream input() {
      return new InputStream() {
        @Override
        public int read() throws IOException {
          byte[] one = new byte[1];
          take(one, 0, 1);
          return one[0] & 0xFF;
        }

        @Override
        public int read(byte[] into, int offset, int length) throws IOException {
          return take(into, offset, length);
        }
      };
    }

    private int take(byte[] into, int offset, int length) throws IOException {
      state.await(() -> !received.isEmpty() || endReason != null || isClosed, Long.MAX_VALUE);
      int count = state.get(() -> takeWaiting(into, offset, length));
      if (count < 0) {
        String reason = state.get(() -> endReason);
        throw new IOException(reason == null ? port + " was closed" : reason);
      }
      return count;
    }

    /** With the state held: the number of bytes taken; -1 if none wait. */
    private int takeWaiting(byte[] into, int offset, int length) {
      byte[] first = received.poll();
      if (first == null) {
        return -1;
      }
      int count = Math.min(length, first.length);
      System.arraycopy(first, 0, into, offset, count);
      if (count < first.length) {
        received.addFirst(Arrays.copyOfRange(first, count, first.length));
      }
      return count;
    }

    @Override
    public OutputStream output() {
      return new OutputStream() {
        @Override
        public void write(int value) throws IOException {
          write(new byte[] {(byte) value}, 0, 1);
        }

        @Override
        public void write(byte[] bytes, int offset, int length) throws IOException {
          byte[] row = Arrays.copyOfRange(bytes, offset, offset + length);
          try {
            GuardCalls.send(
                Objects.requireNonNull(state.get(() -> line)),
                GuardCalls.WRITE,
                call -> {
                  call.writeLong(RealClock.machineNs());
                  call.writeByteArray(row);
                });
          } catch (RemoteException e) {
            ended(DEAD, true);
            throw new IOException(DEAD, e);
          }
        }
      };
    }

    // Two threads may close a link: the next guard needs the port, so the second one waits.
    @Override
    public synchronized void close() throws IOException {
      if (state.get(() -> isClosed)) {
        return;
      }
      change(() -> isClosed = true);
      try {
        if (!hasEndedByItself()) {
          Process.killProcess(state.get(() -> guardsPid));
          WheelGuard.stopWheels(SerialPorts.at(context, port));
        }
      } finally {
        context.unbindService(this);
      }
    }

    /** False if the wheels may still turn. A guard that has never opened its link moved no wheel. */
    private boolean hasEndedByItself() {
      if (state.get(() -> line == null)) {
        return true;
      }
      sendClose();
      state.await(() -> endReason != null, CLOSE_NS);
      return state.get(() -> endReason != null && !isGuardDead);
    }

    private void sendClose() {
      try {
        GuardCalls.send(
            Objects.requireNonNull(state.get(() -> line)), GuardCalls.CLOSE, call -> {});
      } catch (RemoteException e) {
        ended(DEAD, true);
      }
    }

    private void change(Runnable change) {
      state.run(() -> {
        change.run();
        state.signal();
      });
    }

    @Override
    public String toString() {
      return port.toString();
    }
  }
}
