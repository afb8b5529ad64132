package org.starl.robot.serial;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.StreamLink;

/** Links over serial ports: 8 data bits, no parity, 1 stop bit, no flow control. */
public final class SerialLink {

  /** Period at which a waiting read checks whether the port was closed. */
  private static final int READ_MS = 200;

  private SerialLink() {}

  /**
   * Links over the port at {@code path}: {@code /dev/ttyUSB0}, {@code COM3}, a pseudo terminal.
   *
   * @param baud bits per second
   */
  public static ByteLink.Source at(String path, int baud) {
    // Loads the library now: it adds a shutdown hook, which is refused during a shutdown, and then
    // a robot that had to kill its guard could not stop its wheels.
    SerialPort.getVersion();
    return () -> open(path, baud);
  }

  /** Runs {@code work} at the end of the JVM, before its open ports are closed. */
  public static void atShutdown(Runnable work) {
    SerialPort.addShutdownHook(new Thread(work, "end"));
  }

  private static ByteLink open(String path, int baud) throws IOException {
    SerialPort port;
    try {
      port = SerialPort.getCommPort(path);
    } catch (SerialPortInvalidPortException e) {
      throw new IOException(path + ": no such serial port", e);
    }
    port.setComPortParameters(baud, 8, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
    port.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED);
    // A write returns when its bytes have left, because closing discards waiting ones.
    port.setComPortTimeouts(
        SerialPort.TIMEOUT_READ_SEMI_BLOCKING | SerialPort.TIMEOUT_WRITE_BLOCKING, READ_MS, 0);
    if (!port.openPort()) {
      throw new IOException(path + ": cannot be opened, error " + port.getLastErrorCode());
    }
    return new StreamLink(
        path, new PortInput(port, path), new PortOutput(port, path), port::closePort);
  }

  private static IOException lost(String path) {
    return new IOException(path + ": the port was closed, or has gone");
  }

  private static final class PortInput extends InputStream {
    private final SerialPort port;
    private final String path;

    PortInput(SerialPort port, String path) {
      this.port = port;
      this.path = path;
    }

    @Override
    public int read() throws IOException {
      byte[] one = new byte[1];
      return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
    }

    @Override
    public int read(byte[] into, int offset, int length) throws IOException {
      int count = 0;
      while (count == 0 && length > 0) {
        count = port.readBytes(into, length, offset);
        if (count < 0 || !port.isOpen()) {
          throw lost(path);
        }
      }
      return count;
    }
  }

  private static final class PortOutput extends OutputStream {
    private final SerialPort port;
    private final String path;

    PortOutput(SerialPort port, String path) {
      this.port = port;
      this.path = path;
    }

    @Override
    public void write(int value) throws IOException {
      write(new byte[] {(byte) value}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
      for (int done = 0; done < length; ) {
        // A write to a closed port would never return.
        int count = port.isOpen() ? port.writeBytes(bytes, length - done, offset + done) : -1;
        if (count < 0 || !port.isOpen()) {
          throw lost(path);
        }
        done += count;
      }
    }
  }
}
