package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two robots agree on a key that no third one has; a file of another kind is refused. */
class RobotKeyTest {

  @TempDir private Path folder;

  private record Robot(RobotKey secret, PublicRobotKey published) {}

  private Robot robot(String name) throws IOException {
    Path file = folder.resolve(name + ".key");
    String text = RobotKey.generate(file).toString();
    return new Robot(
        RobotKey.read(file), Objects.requireNonNull(PublicRobotKey.parseOrNull(text)).get(0));
  }

  @Test
  void twoRobotsShareAKeyThatAThirdDoesNotHave() throws IOException {
    Robot a = robot("a");
    Robot b = robot("b");
    Robot thief = robot("c");

    assertThat(a.secret.pairKey(b.published)).isEqualTo(b.secret.pairKey(a.published));
    assertThat(thief.secret.pairKey(a.published)).isNotEqualTo(b.secret.pairKey(a.published));
    assertThat(thief.secret.pairKey(b.published)).isNotEqualTo(a.secret.pairKey(b.published));
    assertThat(a.secret.isAmong(List.of(b.published, a.published))).isTrue();
    assertThat(a.secret.isAmong(List.of(b.published))).isFalse();
  }

  @Test
  void onlyItsOwnerMayReadTheFile() throws IOException {
    robot("a");
    Path file = folder.resolve("a.key");

    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
        .isEqualTo("rw-------");
    assertThatThrownBy(() -> RobotKey.generate(file))
        .hasMessage(file + ": exists; expected a new file: a key in use is not replaced");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r--r--"));
    assertThatThrownBy(() -> RobotKey.read(file)).hasMessageContaining("only its owner may read");
  }

  @Test
  void aSecretOfZeroIsRefused() throws IOException {
    robot("a");
    Path file = folder.resolve("a.key");
    List<String> lines = Files.readAllLines(file);
    byte[] encoded =
        Base64.getDecoder().decode(String.join("", lines.subList(1, lines.size() - 1)));
    // The 32 bytes of the secret follow the header of 35 or 36 bytes: they end the encoding.
    Arrays.fill(encoded, encoded.length - 32, encoded.length, (byte) 0);
    Path zero = folder.resolve("zero.key");
    KeyFile.writeSecret(
        zero,
        (lines.get(0)
                + "\n"
                + Base64.getEncoder().encodeToString(encoded)
                + "\n"
                + lines.get(lines.size() - 1))
            .getBytes(java.nio.charset.StandardCharsets.US_ASCII));

    assertThatThrownBy(() -> RobotKey.read(zero)).hasMessageContaining("expected a robot's key");
  }

  @Test
  void aPointOffTheCurveIsRefused() throws IOException {
    String text = robot("a").published.toString();
    byte[] encoded = Base64.getDecoder().decode(text);
    for (int bit = 0; bit < 8 * 64; bit += 7) {
      byte[] changed = encoded.clone();
      int at = changed.length - 64 + bit / 8;
      changed[at] ^= (byte) (1 << (bit % 8));
      assertThat(PublicRobotKey.parseOrNull(Base64.getEncoder().encodeToString(changed)))
          .as("bit %d of the point", bit)
          .isNull();
    }
  }

  @Test
  void textsThatAreNotKeysAreRefused() throws IOException {
    String key = robot("a").published.toString();

    assertThat(PublicRobotKey.parseOrNull(key + "  " + key)).hasSize(2);
    for (String text : List.of("", "x", key + "x", key.substring(1), key + " x", key + "," + key)) {
      assertThat(PublicRobotKey.parseOrNull(text)).as(text).isNull();
    }
    Path hex = folder.resolve("hex.key");
    KeyFile.generate(hex);
    assertThatThrownBy(() -> RobotKey.read(hex)).hasMessageContaining("is not a key; expected");
  }

  /** OpenSSL makes such a file too, and reads ours: the format is not our own. */
  @Test
  @Tag("realtime")
  void opensslReadsAndMakesKeys() throws Exception {
    Robot ours = robot("ours");
    String read = openssl("pkey", "-in", folder.resolve("ours.key").toString(), "-pubout");
    assertThat(read.replace("\n", "")).contains(ours.published.toString());

    String made = openssl("genpkey", "-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:P-256");
    Path file = folder.resolve("theirs.key");
    KeyFile.writeSecret(file, made.getBytes(java.nio.charset.StandardCharsets.US_ASCII));
    String published =
        openssl("pkey", "-in", file.toString(), "-pubout")
            .replaceAll("-----[A-Z ]+-----", "")
            .replace("\n", "");
    assertThat(
            RobotKey.read(file)
                .isAmong(Objects.requireNonNull(PublicRobotKey.parseOrNull(published))))
        .isTrue();
    assertThat(new BigInteger(1, Base64.getDecoder().decode(published))).isPositive();
  }

  private static String openssl(String... args) throws Exception {
    List<String> command = new java.util.ArrayList<>(List.of("openssl"));
    command.addAll(List.of(args));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    String out = new String(process.getInputStream().readAllBytes());
    assertThat(process.waitFor()).as(out).isZero();
    return out;
  }
}
