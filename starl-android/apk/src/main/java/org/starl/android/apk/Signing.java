package org.starl.android.apk;

import com.android.apksig.ApkSigner;
import com.android.apksig.ApkVerifier;
import com.android.apksig.KeyConfig;
import com.android.apksig.apk.ApkFormatException;
import java.io.IOException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.util.List;

/** Signs APKs by the schemes v2 and v3, and verifies them as a phone does. */
final class Signing {

  private static final String SIGNER = "starl";

  private Signing() {}

  /** Signs, and aligns what is not compressed, as a phone wants to map it. */
  static void sign(Path unsigned, SigningKey key, int minSdk, Path signed)
      throws ApkException, IOException {
    ApkSigner.SignerConfig signer =
        new ApkSigner.SignerConfig.Builder(SIGNER, new KeyConfig.Jca(key.key()), key.chain())
            .build();
    try {
      new ApkSigner.Builder(List.of(signer))
          .setInputApk(unsigned.toFile())
          .setOutputApk(signed.toFile())
          .setMinSdkVersion(minSdk)
          // The oldest scheme is for phones before Android 7.
          .setV1SigningEnabled(false)
          .setV2SigningEnabled(true)
          .setV3SigningEnabled(true)
          .setAlignmentPreserved(false)
          .build()
          .sign();
    } catch (ApkFormatException | GeneralSecurityException e) {
      throw ApkException.failed("the APK cannot be signed: " + e.getMessage());
    }
  }

  /**
   * The description of the verified signature.
   *
   * @throws ApkException unless both schemes verify for every phone from {@code minSdk} on
   */
  static String verify(Path apk, int minSdk) throws ApkException, IOException {
    ApkVerifier.Result result;
    try {
      result =
          new ApkVerifier.Builder(apk.toFile())
              .setMinCheckedPlatformVersion(minSdk)
              .build()
              .verify();
    } catch (ApkFormatException | GeneralSecurityException e) {
      throw ApkException.failed(apk + " is no APK: " + e.getMessage());
    }
    if (!result.isVerified()
        || !result.isVerifiedUsingV2Scheme()
        || !result.isVerifiedUsingV3Scheme()) {
      throw ApkException.failed(apk + " does not verify: " + result.getAllErrors());
    }
    return "verified by the signature schemes v2 and v3 for API "
        + minSdk
        + " and later, signed by "
        + result.getSignerCertificates().get(0).getSubjectX500Principal().getName();
  }
}
