package org.starl.android.apk;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.Certificate;
import java.security.cert.X509Certificate;
import java.util.ArrayList;
import java.util.List;

/**
 * The key that signs an APK. Immutable.
 *
 * @param chain the key's certificate first
 */
record SigningKey(PrivateKey key, List<X509Certificate> chain) {

  private static final String ALIAS = "debug";

  /** Public, like Android's debug key: it protects nothing. */
  private static final String PASSWORD = "android";

  /**
   * The key in a PKCS12 file.
   *
   * @throws ApkException if there is none, or the password does not open it
   */
  static SigningKey read(Path file, String password, String alias) throws ApkException {
    if (!Files.isRegularFile(file)) {
      throw ApkException.badInput(file + ": no such file; expected a PKCS12 file");
    }
    try (InputStream bytes = Files.newInputStream(file)) {
      KeyStore keys = KeyStore.getInstance("PKCS12");
      keys.load(bytes, password.toCharArray());
      if (!(keys.getKey(alias, password.toCharArray()) instanceof PrivateKey key)) {
        throw ApkException.badInput(file + " has no private key '" + alias + "'");
      }
      List<X509Certificate> chain = new ArrayList<>();
      for (Certificate certificate : keys.getCertificateChain(alias)) {
        chain.add((X509Certificate) certificate);
      }
      return new SigningKey(key, List.copyOf(chain));
    } catch (IOException | GeneralSecurityException e) {
      throw ApkException.badInput(
          file + ": cannot be opened with that password as a PKCS12 file: " + e.getMessage());
    }
  }

  /** The debug key, which is made in {@code folder} when first needed. */
  static SigningKey debug(Path folder) throws ApkException, IOException {
    Path file = folder.resolve("android-debug.p12");
    if (!Files.exists(file)) {
      Files.createDirectories(folder);
      Path keytool = Path.of(System.getProperty("java.home"), "bin", "keytool");
      Tool.run(
          List.of(
              keytool.toString(),
              "-genkeypair",
              "-keystore",
              file.toString(),
              "-storetype",
              "PKCS12",
              "-storepass",
              PASSWORD,
              "-alias",
              ALIAS,
              "-keyalg",
              "RSA",
              "-keysize",
              "3072",
              "-validity",
              "10000",
              "-dname",
              "CN=StarL debug"));
      if (Files.getFileStore(file).supportsFileAttributeView("posix")) {
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
      }
    }
    return read(file, PASSWORD, ALIAS);
  }

  /** Reads the password from the first line of a file, so that it is not in a command line. */
  static String password(Path file) throws ApkException {
    try {
      return Files.readString(file, StandardCharsets.UTF_8).lines().findFirst().orElse("");
    } catch (IOException e) {
      throw ApkException.badInput("--key-password-file " + file + ": cannot be read");
    }
  }
}
