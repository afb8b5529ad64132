package org.starl.launch;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import org.starl.robot.realtime.RealClock;

/**
 * Bytes from a program to its {@link GuardProcess}: each write is sent with its time, so that the guard
 * recognises old commands behind a stall.
 */
final class GuardedOutput extends OutputStream {

  static final int MAX_BYTES = 255;

  private final DataOutputStream out;

  GuardedOutput(OutputStream out) {
    this.out = new DataOutputStream(out);
  }

  /** The bytes of one write, and when they were written, on the machine's clock. */
  static final class Write {
    final long sentNs;
    final byte[] bytes;

    private Write(long sentNs, byte[] bytes) {
      this.sentNs = sentNs;
      this.bytes = bytes;
    }

    /** Reads one; throws an EOFException at the end. */
    static Write read(DataInputStream in) throws IOException {
      long sentNs = in.readLong();
      return new Write(sentNs, in.readNBytes(in.readUnsignedByte()));
    }
  }

  @Override
  public void write(int value) throws IOException {
    write(new byte[] {(byte) value}, 0, 1);
  }

  @Override
  public void write(byte[] bytes, int offset, int length) throws IOException {
    for (int done = 0; done < length; ) {
      int count = Math.min(length - done, MAX_BYTES);
      out.writeLong(RealClock.machineNs());
      out.writeByte(count);
      out.write(bytes, offset + done, count);
      done += count;
    }
  }

  @Override
  public void flush() throws IOException {
    out.flush();
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
