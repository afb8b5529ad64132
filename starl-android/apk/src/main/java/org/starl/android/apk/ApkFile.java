package org.starl.android.apk;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Enumeration;
import java.util.Set;
import java.util.TreeMap;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;

/** Puts the parts of an unsigned APK together. */
final class ApkFile {

  /**
   * The earliest time of the zip format: 1980. All entries have this time, for reproducible files.
   */
  private static final long NO_TIME_MS = 315_532_800_000L;

  private ApkFile() {}

  /**
   * Writes {@code linked}'s entries, then the dex files of {@code dexFolder}, then the names of the
   * makers of apps.
   */
  static void write(Path linked, Path dexFolder, Set<String> apps, Path unsigned)
      throws IOException {
    TreeMap<String, Path> dexFiles = new TreeMap<>();
    try (DirectoryStream<Path> files = Files.newDirectoryStream(dexFolder, "*.dex")) {
      for (Path file : files) {
        dexFiles.put(String.valueOf(file.getFileName()), file);
      }
    }
    try (ZipFile from = new ZipFile(linked.toFile());
        ZipOutputStream to = new ZipOutputStream(Files.newOutputStream(unsigned))) {
      for (Enumeration<? extends ZipEntry> all = from.entries(); all.hasMoreElements(); ) {
        ZipEntry entry = all.nextElement();
        try (InputStream bytes = from.getInputStream(entry)) {
          add(to, entry.getName(), bytes.readAllBytes(), entry.getMethod() == ZipEntry.STORED);
        }
      }
      for (String name : dexFiles.keySet()) {
        add(to, name, Files.readAllBytes(dexFiles.get(name)), false);
      }
      byte[] services = String.join("\n", apps).getBytes(StandardCharsets.UTF_8);
      add(to, Selection.SERVICES, services, false);
    }
  }

  private static void add(ZipOutputStream to, String name, byte[] bytes, boolean isStored)
      throws IOException {
    ZipEntry entry = new ZipEntry(name);
    entry.setTime(NO_TIME_MS);
    if (isStored) {
      CRC32 crc = new CRC32();
      crc.update(bytes);
      entry.setMethod(ZipEntry.STORED);
      entry.setSize(bytes.length);
      entry.setCompressedSize(bytes.length);
      entry.setCrc(crc.getValue());
    }
    to.putNextEntry(entry);
    to.write(bytes);
    to.closeEntry();
  }
}
