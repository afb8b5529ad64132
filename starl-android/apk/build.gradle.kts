plugins {
    application
    id("maven-publish")
}

description = "Makes, signs and verifies the APK of the app for phones"

dependencies {
    implementation(project(":starl-android-app"))
    // Android's resources and classes: what the APK is linked against.
    runtimeOnly(libs.android.resources)
    implementation(libs.r8)
    implementation(libs.apksig)
    implementation(libs.picocli)
    implementation(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

application {
    mainClass.set("org.starl.android.apk.Main")
    applicationName = "starl-apk"
}
