package org.starl.robot.udp;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import org.starl.platform.DeploymentKey;

/**
 * A deployment's key in a file: one line of 64 hexadecimal digits. If the file system has permissions,
 * only the owner may read the file. No message of this class shows the file's content.
 */
public final class KeyFile {

  private static final String POSIX = "posix";
  private static final String OWNER_ONLY = "rw-------";
  private static final int DIGITS = 2 * DeploymentKey.BYTES;
  private static final int RADIX = 16;

  /** Greatest length of such a file: a line ending of either kind may follow the digits. */
  public static final int MAX_BYTES = DIGITS + 2;

  private static final String EXPECTED =
      "expected a key, as 'starl keygen' makes it: one line of " + DIGITS + " hexadecimal digits";

  private KeyFile() {}

  /**
   * Reads a key.
   *
   * @throws IOException if the file is missing, not a key, or readable by others; the message is one
   *     line with the file and what was expected
   */
  public static DeploymentKey read(Path file) throws IOException {
    return parse(file, readSecret(file, MAX_BYTES, EXPECTED));
  }

  /**
   * Reads a file that only its owner may read.
   *
   * @param expected what it contains, for messages
   * @throws IOException if it is missing, longer than {@code maxBytes}, or readable by others
   */
  static byte[] readSecret(Path file, int maxBytes, String expected) throws IOException {
    if (!Files.isRegularFile(file)) {
      throw new IOException(file + ": no such file; " + expected);
    }
    refuseOthers(file);
    if (Files.size(file) > maxBytes) {
      throw new IOException(file + ": is not a key; " + expected);
    }
    return Files.readAllBytes(file);
  }

  /** The key in these bytes of {@code file}. */
  static DeploymentKey parse(Path file, byte[] bytes) throws IOException {
    if (bytes.length < DIGITS || bytes.length > MAX_BYTES) {
      throw notAKey(file);
    }
    byte[] secret = new byte[DeploymentKey.BYTES];
    for (int i = 0; i < secret.length; i++) {
      int high = Character.digit(bytes[2 * i], RADIX);
      int low = Character.digit(bytes[2 * i + 1], RADIX);
      if (high < 0 || low < 0) {
        throw notAKey(file);
      }
      secret[i] = (byte) (high << 4 | low);
    }
    for (int i = DIGITS; i < bytes.length; i++) {
      if (bytes[i] != '\n' && bytes[i] != '\r') {
        throw notAKey(file);
      }
    }
    if (Arrays.equals(secret, new byte[DeploymentKey.BYTES])) {
      throw new IOException(file + ": is a key of zeros; " + EXPECTED);
    }
    return new DeploymentKey(secret);
  }

  /**
   * Writes a new key, drawn from the machine's secure random source, into a new file.
   *
   * @throws IOException if the file exists or cannot be created; the message is one line for people
   */
  public static void generate(Path file) throws IOException {
    byte[] secret = new byte[DeploymentKey.BYTES];
    new SecureRandom().nextBytes(secret);
    StringBuilder line = new StringBuilder();
    for (byte b : secret) {
      line.append(Character.forDigit(b >> 4 & 0xF, RADIX))
          .append(Character.forDigit(b & 0xF, RADIX));
    }
    writeSecret(file, line.append('\n').toString().getBytes(StandardCharsets.US_ASCII));
  }

  /** Writes a new file that only its owner may read. */
  static void writeSecret(Path file, byte[] bytes) throws IOException {
    try (OutputStream out =
        Channels.newOutputStream(
            Files.newByteChannel(
                file,
                EnumSet.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
                permissions()))) {
      out.write(bytes);
    } catch (FileAlreadyExistsException e) {
      throw new IOException(
          file + ": exists; expected a new file: a key in use is not replaced", e);
    } catch (AccessDeniedException e) {
      throw new IOException(file + ": expected a folder that this user may write into", e);
    } catch (NoSuchFileException e) {
      throw new IOException(file + ": expected an existing folder", e);
    }
  }

  private static FileAttribute<?>[] permissions() {
    if (!FileSystems.getDefault().supportedFileAttributeViews().contains(POSIX)) {
      return new FileAttribute<?>[0];
    }
    return new FileAttribute<?>[] {
      PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(OWNER_ONLY))
    };
  }

  private static void refuseOthers(Path file) throws IOException {
    if (!file.getFileSystem().supportedFileAttributeViews().contains(POSIX)) {
      return;
    }
    Set<PosixFilePermission> granted = Files.getPosixFilePermissions(file);
    Set<PosixFilePermission> others =
        EnumSet.of(
            PosixFilePermission.GROUP_READ,
            PosixFilePermission.GROUP_WRITE,
            PosixFilePermission.OTHERS_READ,
            PosixFilePermission.OTHERS_WRITE);
    others.retainAll(granted);
    if (!others.isEmpty()) {
      throw new IOException(
          String.format(
              "%s: %s: expected a key that only its owner may read ('chmod 600 %s')",
              file, PosixFilePermissions.toString(granted), file));
    }
  }

  private static IOException notAKey(Path file) {
    return new IOException(file + ": is not a key; " + EXPECTED);
  }
}
