//! Raises the priority of the thread in which Aravis receives packets.
//!
//! Packets wait in a buffer that fills within milliseconds, but a thread that shares its processor with
//! a measurement or another program may be delayed longer. Real-time scheduling is tried first, because
//! the kernel applies nice levels only within a session or service.

use std::{ffi::c_void, ptr};

use aravis::{
    Camera, Stream,
    glib::{
        self,
        translate::{ToGlibPtr, from_glib, from_glib_full},
    },
};
use aravis_sys::{
    ARV_STREAM_CALLBACK_TYPE_INIT, ArvBuffer, ArvStreamCallbackType, arv_camera_create_stream,
    arv_make_thread_high_priority, arv_make_thread_realtime,
};

use crate::gige::{RECEIVING_NICE, RECEIVING_REALTIME_PRIORITY};

/// Creates a camera's stream, whose thread raises its own priority.
///
/// # Errors
/// Errors of Aravis: the camera does not answer, or refuses the stream.
#[expect(unsafe_code)]
pub(super) fn create_stream(camera: &Camera) -> Result<Stream, glib::Error> {
    let mut error = ptr::null_mut();
    // SAFETY: the camera outlives the call. `raise_priority` uses no user data, so none has to
    // outlive the stream. Aravis returns a stream that we own, or sets the error that we own.
    unsafe {
        let stream = arv_camera_create_stream(
            camera.to_glib_none().0,
            Some(raise_priority),
            ptr::null_mut(),
            &mut error,
        );
        if error.is_null() { Ok(from_glib_full(stream)) } else { Err(from_glib_full(error)) }
    }
}

/// Called by Aravis on the stream's thread: at its start, for every buffer, and at its end.
#[expect(unsafe_code)]
unsafe extern "C" fn raise_priority(
    _user_data: *mut c_void,
    kind: ArvStreamCallbackType,
    _buffer: *mut ArvBuffer,
) {
    if kind != ARV_STREAM_CALLBACK_TYPE_INIT {
        return;
    }
    // SAFETY: the calls have no precondition; they act on the thread that makes them.
    let raised = unsafe {
        from_glib(arv_make_thread_realtime(RECEIVING_REALTIME_PRIORITY))
            || from_glib(arv_make_thread_high_priority(RECEIVING_NICE))
    };
    if !raised {
        tracing::warn!(
            "the receiving thread could not raise its priority: frames may be \
             lost while the machine is busy; `lfpiv doctor` says what to do"
        );
    }
}
