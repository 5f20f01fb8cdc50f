(()=>{var Gm=0,Mf=1,Vm=2;var Ar=1,Hm=2,Lo=3,or=0,ni=1,Ri=2,Tr=0,No=1,bf=2,wf=3,Ef=4,Wm=5;var Cr=100,Xm=101,qm=102,Ym=103,$m=104,Zm=200,Jm=201,jm=202,Km=203,Af=204,Tf=205,Qm=206,eg=207,tg=208,ng=209,ig=210,sg=211,rg=212,og=213,ag=214,mc=0,gc=1,_c=2,Mo=3,xc=4,vc=5,yc=6,Sc=7,$c=0,lg=1,cg=2,fs=0,Cf=1,Rf=2,Pf=3,If=4,Lf=5,Nf=6,Ha=7;var Df=300,Rr=301,Do=302,Zc=303,Jc=304,Mc=1e3,cs=1001,bc=1002,On=1003,ug=1004;var Wa=1005;var ti=1006,jc=1007;var Ns=1008;var Wn=1009,Uf=1010,Ff=1011,Uo=1012,Kc=1013,Yi=1014,Pi=1015,$i=1016,Qc=1017,eu=1018,Pr=1020,Of=35902,Bf=35899,kf=1021,zf=1022,li=1023,Cs=1026,Ds=1027,Fo=1028,tu=1029,Zi=1030,nu=1031;var iu=1033,Xa=33776,qa=33777,Ya=33778,$a=33779,su=35840,ru=35841,ou=35842,au=35843,lu=36196,cu=37492,uu=37496,hu=37488,fu=37489,Za=37490,du=37491,pu=37808,mu=37809,gu=37810,_u=37811,xu=37812,vu=37813,yu=37814,Su=37815,Mu=37816,bu=37817,wu=37818,Eu=37819,Au=37820,Tu=37821,Cu=36492,Ru=36494,Pu=36495,Iu=36283,Lu=36284,Ja=36285,Nu=36286;var ya=2300,wc=2301,dc=2302,pf=2303,mf=2400,gf=2401,_f=2402;var hg=3200;var ja=0,fg=1,Us="",Qn="srgb",Sa="srgb-linear",Ma="linear",Ct="srgb";var pc=7680;var dg=519,pg=512,mg=513,gg=514,Gf=515,_g=516,xg=517,Vf=518,Hf=519,vg=35044;var Wf="300 es",Ti=2e3,bo=2001;function XS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function qS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ba(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function yg(){let n=ba("canvas");return n.style.display="block",n}var um={},wo=null;function Xf(...n){let e="THREE."+n.shift();wo?wo("log",e,...n):console.log(e,...n)}function Sg(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Je(...n){n=Sg(n);let e="THREE."+n.shift();if(wo)wo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function et(...n){n=Sg(n);let e="THREE."+n.shift();if(wo)wo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function va(...n){let e=n.join(" ");e in um||(um[e]=!0,Je(...n))}function Mg(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var bg={[mc]:mc,[_c]:yc,[xc]:xc,[Mo]:vc,[gc]:gc,[yc]:_c,[Sc]:Sc,[vc]:Mo},Hi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Wh=Math.PI/180,Ec=180/Math.PI;function Ka(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Vn[n&255]+Vn[n>>8&255]+Vn[n>>16&255]+Vn[n>>24&255]+"-"+Vn[e&255]+Vn[e>>8&255]+"-"+Vn[e>>16&15|64]+Vn[e>>24&255]+"-"+Vn[t&63|128]+Vn[t>>8&255]+"-"+Vn[t>>16&255]+Vn[t>>24&255]+Vn[i&255]+Vn[i>>8&255]+Vn[i>>16&255]+Vn[i>>24&255]).toLowerCase()}function St(n,e,t){return Math.max(e,Math.min(t,n))}function YS(n,e){return(n%e+e)%e}function Xh(n,e,t){return(1-t)*n+t*e}function wg(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function qf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function $S(n,e){if(e.constructor===Float32Array)return n;let t=qf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function ZS(n,e){if(e.constructor===Float32Array)return n;let t=qf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var ct=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=St(this.x,e.x,t.x),this.y=St(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=St(this.x,e,t),this.y=St(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(St(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(St(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},At=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],p=r[o+1],g=r[o+2],y=r[o+3];if(f!==y||l!==h||c!==p||u!==g){let d=l*h+c*p+u*g+f*y;d<0&&(h=-h,p=-p,g=-g,y=-y,d=-d);let m=1-a;if(d<.9995){let v=Math.acos(d),T=Math.sin(v);m=Math.sin(m*v)/T,a=Math.sin(a*v)/T,l=l*m+h*a,c=c*m+p*a,u=u*m+g*a,f=f*m+y*a}else{l=l*m+h*a,c=c*m+p*a,u=u*m+g*a,f=f*m+y*a;let v=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=v,c*=v,u*=v,f*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],p=r[o+2],g=r[o+3];return e[t]=a*g+u*f+l*p-c*h,e[t+1]=l*g+u*h+c*f-a*p,e[t+2]=c*g+u*p+a*h-l*f,e[t+3]=u*g-a*f-l*h-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),p=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*p*g,this._y=c*p*f-h*u*g,this._z=c*u*g+h*p*f,this._w=c*u*f-h*p*g;break;case"YXZ":this._x=h*u*f+c*p*g,this._y=c*p*f-h*u*g,this._z=c*u*g-h*p*f,this._w=c*u*f+h*p*g;break;case"ZXY":this._x=h*u*f-c*p*g,this._y=c*p*f+h*u*g,this._z=c*u*g+h*p*f,this._w=c*u*f-h*p*g;break;case"ZYX":this._x=h*u*f-c*p*g,this._y=c*p*f+h*u*g,this._z=c*u*g-h*p*f,this._w=c*u*f+h*p*g;break;case"YZX":this._x=h*u*f+c*p*g,this._y=c*p*f+h*u*g,this._z=c*u*g-h*p*f,this._w=c*u*f-h*p*g;break;case"XZY":this._x=h*u*f-c*p*g,this._y=c*p*f-h*u*g,this._z=c*u*g+h*p*f,this._w=c*u*f+h*p*g;break;default:Je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let p=.5/Math.sqrt(h+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>f){let p=2*Math.sqrt(1+i-a-f);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>f){let p=2*Math.sqrt(1+a-i-f);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+f-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(St(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},B=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(hm.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(hm.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=St(this.x,e.x,t.x),this.y=St(this.y,e.y,t.y),this.z=St(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=St(this.x,e,t),this.y=St(this.y,e,t),this.z=St(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(St(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return qh.copy(this).projectOnVector(e),this.sub(qh)}reflect(e){return this.sub(qh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(St(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},qh=new B,hm=new At,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],p=i[5],g=i[8],y=s[0],d=s[3],m=s[6],v=s[1],T=s[4],S=s[7],C=s[2],A=s[5],_=s[8];return r[0]=o*y+a*v+l*C,r[3]=o*d+a*T+l*A,r[6]=o*m+a*S+l*_,r[1]=c*y+u*v+f*C,r[4]=c*d+u*T+f*A,r[7]=c*m+u*S+f*_,r[2]=h*y+p*v+g*C,r[5]=h*d+p*T+g*A,r[8]=h*m+p*S+g*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,p=c*r-o*l,g=t*f+i*h+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=f*y,e[1]=(s*c-u*i)*y,e[2]=(a*i-s*o)*y,e[3]=h*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=p*y,e[7]=(i*l-c*t)*y,e[8]=(o*t-i*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return va("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Yh.makeScale(e,t)),this}rotate(e){return va("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Yh.makeRotation(-e)),this}translate(e,t){return va("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Yh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Yh=new nt,fm=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),dm=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function JS(){let n={enabled:!0,workingColorSpace:Sa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ct&&(s.r=Ts(s.r),s.g=Ts(s.g),s.b=Ts(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ct&&(s.r=So(s.r),s.g=So(s.g),s.b=So(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Us?Ma:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Sa]:{primaries:e,whitePoint:i,transfer:Ma,toXYZ:fm,fromXYZ:dm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Qn},outputColorSpaceConfig:{drawingBufferColorSpace:Qn}},[Qn]:{primaries:e,whitePoint:i,transfer:Ct,toXYZ:fm,fromXYZ:dm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Qn}}}),n}var xt=JS();function Ts(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function So(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var oo,Ac=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{oo===void 0&&(oo=ba("canvas")),oo.width=e.width,oo.height=e.height;let s=oo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=oo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ba("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ts(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Ts(t[i]/255)*255):t[i]=Ts(t[i]);return{data:t,width:e.width,height:e.height}}else return Je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},jS=0,Eo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:jS++}),this.uuid=Ka(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push($h(s[o].image)):r.push($h(s[o]))}else r=$h(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function $h(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ac.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Je("Texture: Unable to serialize Texture."),{})}var KS=0,Zh=new B,oi=class n extends Hi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=cs,s=cs,r=ti,o=Ns,a=li,l=Wn,c=n.DEFAULT_ANISOTROPY,u=Us){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:KS++}),this.uuid=Ka(),this.name="",this.source=new Eo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ct(0,0),this.repeat=new ct(1,1),this.center=new ct(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Zh).x}get height(){return this.source.getSize(Zh).y}get depth(){return this.source.getSize(Zh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Df)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Mc:e.x=e.x-Math.floor(e.x);break;case cs:e.x=e.x<0?0:1;break;case bc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Mc:e.y=e.y-Math.floor(e.y);break;case cs:e.y=e.y<0?0:1;break;case bc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};oi.DEFAULT_IMAGE=null;oi.DEFAULT_MAPPING=Df;oi.DEFAULT_ANISOTROPY=1;var Ht=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],p=l[5],g=l[9],y=l[2],d=l[6],m=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-y)<.01&&Math.abs(g-d)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+y)<.1&&Math.abs(g+d)<.1&&Math.abs(c+p+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,S=(p+1)/2,C=(m+1)/2,A=(u+h)/4,_=(f+y)/4,w=(g+d)/4;return T>S&&T>C?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=A/i,r=_/i):S>C?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=A/s,r=w/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=_/r,s=w/r),this.set(i,s,r,t),this}let v=Math.sqrt((d-g)*(d-g)+(f-y)*(f-y)+(h-u)*(h-u));return Math.abs(v)<.001&&(v=1),this.x=(d-g)/v,this.y=(f-y)/v,this.z=(h-u)/v,this.w=Math.acos((c+p+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=St(this.x,e.x,t.x),this.y=St(this.y,e.y,t.y),this.z=St(this.z,e.z,t.z),this.w=St(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=St(this.x,e,t),this.y=St(this.y,e,t),this.z=St(this.z,e,t),this.w=St(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(St(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Tc=class extends Hi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ti,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Ht(0,0,e,t),this.scissorTest=!1,this.viewport=new Ht(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new oi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ti,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Eo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},_i=class extends Tc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},wa=class extends oi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Cc=class extends oi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=cs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var vt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,h,p,g,y,d){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,p,g,y,d)}set(e,t,i,s,r,o,a,l,c,u,f,h,p,g,y,d){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=f,m[14]=h,m[3]=p,m[7]=g,m[11]=y,m[15]=d,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/ao.setFromMatrixColumn(e,0).length(),r=1/ao.setFromMatrixColumn(e,1).length(),o=1/ao.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,p=o*f,g=a*u,y=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=p+g*c,t[5]=h-y*c,t[9]=-a*l,t[2]=y-h*c,t[6]=g+p*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,p=l*f,g=c*u,y=c*f;t[0]=h+y*a,t[4]=g*a-p,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=p*a-g,t[6]=y+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,p=l*f,g=c*u,y=c*f;t[0]=h-y*a,t[4]=-o*f,t[8]=g+p*a,t[1]=p+g*a,t[5]=o*u,t[9]=y-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,p=o*f,g=a*u,y=a*f;t[0]=l*u,t[4]=g*c-p,t[8]=h*c+y,t[1]=l*f,t[5]=y*c+h,t[9]=p*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,p=o*c,g=a*l,y=a*c;t[0]=l*u,t[4]=y-h*f,t[8]=g*f+p,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*f+g,t[10]=h-y*f}else if(e.order==="XZY"){let h=o*l,p=o*c,g=a*l,y=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+y,t[5]=o*u,t[9]=p*f-g,t[2]=g*f-p,t[6]=a*u,t[10]=y*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(QS,e,eM)}lookAt(e,t,i){let s=this.elements;return mi.subVectors(e,t),mi.lengthSq()===0&&(mi.z=1),mi.normalize(),$s.crossVectors(i,mi),$s.lengthSq()===0&&(Math.abs(i.z)===1?mi.x+=1e-4:mi.z+=1e-4,mi.normalize(),$s.crossVectors(i,mi)),$s.normalize(),Wl.crossVectors(mi,$s),s[0]=$s.x,s[4]=Wl.x,s[8]=mi.x,s[1]=$s.y,s[5]=Wl.y,s[9]=mi.y,s[2]=$s.z,s[6]=Wl.z,s[10]=mi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],p=i[13],g=i[2],y=i[6],d=i[10],m=i[14],v=i[3],T=i[7],S=i[11],C=i[15],A=s[0],_=s[4],w=s[8],U=s[12],L=s[1],I=s[5],k=s[9],W=s[13],N=s[2],V=s[6],Y=s[10],G=s[14],ae=s[3],q=s[7],K=s[11],ne=s[15];return r[0]=o*A+a*L+l*N+c*ae,r[4]=o*_+a*I+l*V+c*q,r[8]=o*w+a*k+l*Y+c*K,r[12]=o*U+a*W+l*G+c*ne,r[1]=u*A+f*L+h*N+p*ae,r[5]=u*_+f*I+h*V+p*q,r[9]=u*w+f*k+h*Y+p*K,r[13]=u*U+f*W+h*G+p*ne,r[2]=g*A+y*L+d*N+m*ae,r[6]=g*_+y*I+d*V+m*q,r[10]=g*w+y*k+d*Y+m*K,r[14]=g*U+y*W+d*G+m*ne,r[3]=v*A+T*L+S*N+C*ae,r[7]=v*_+T*I+S*V+C*q,r[11]=v*w+T*k+S*Y+C*K,r[15]=v*U+T*W+S*G+C*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],p=e[14],g=e[3],y=e[7],d=e[11],m=e[15],v=l*p-c*h,T=a*p-c*f,S=a*h-l*f,C=o*p-c*u,A=o*h-l*u,_=o*f-a*u;return t*(y*v-d*T+m*S)-i*(g*v-d*C+m*A)+s*(g*T-y*C+m*_)-r*(g*S-y*A+d*_)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],p=e[11],g=e[12],y=e[13],d=e[14],m=e[15],v=t*a-i*o,T=t*l-s*o,S=t*c-r*o,C=i*l-s*a,A=i*c-r*a,_=s*c-r*l,w=u*y-f*g,U=u*d-h*g,L=u*m-p*g,I=f*d-h*y,k=f*m-p*y,W=h*m-p*d,N=v*W-T*k+S*I+C*L-A*U+_*w;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/N;return e[0]=(a*W-l*k+c*I)*V,e[1]=(s*k-i*W-r*I)*V,e[2]=(y*_-d*A+m*C)*V,e[3]=(h*A-f*_-p*C)*V,e[4]=(l*L-o*W-c*U)*V,e[5]=(t*W-s*L+r*U)*V,e[6]=(d*S-g*_-m*T)*V,e[7]=(u*_-h*S+p*T)*V,e[8]=(o*k-a*L+c*w)*V,e[9]=(i*L-t*k-r*w)*V,e[10]=(g*A-y*S+m*v)*V,e[11]=(f*S-u*A-p*v)*V,e[12]=(a*U-o*I-l*w)*V,e[13]=(t*I-i*U+s*w)*V,e[14]=(y*T-g*C-d*v)*V,e[15]=(u*C-f*T+h*v)*V,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,p=r*u,g=r*f,y=o*u,d=o*f,m=a*f,v=l*c,T=l*u,S=l*f,C=i.x,A=i.y,_=i.z;return s[0]=(1-(y+m))*C,s[1]=(p+S)*C,s[2]=(g-T)*C,s[3]=0,s[4]=(p-S)*A,s[5]=(1-(h+m))*A,s[6]=(d+v)*A,s[7]=0,s[8]=(g+T)*_,s[9]=(d-v)*_,s[10]=(1-(h+y))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=ao.set(s[0],s[1],s[2]).length(),a=ao.set(s[4],s[5],s[6]).length(),l=ao.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ki.copy(this);let c=1/o,u=1/a,f=1/l;return ki.elements[0]*=c,ki.elements[1]*=c,ki.elements[2]*=c,ki.elements[4]*=u,ki.elements[5]*=u,ki.elements[6]*=u,ki.elements[8]*=f,ki.elements[9]*=f,ki.elements[10]*=f,t.setFromRotationMatrix(ki),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ti,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),p=(i+s)/(i-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===Ti)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===bo)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ti,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),p=-(i+s)/(i-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===Ti)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===bo)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},ao=new B,ki=new vt,QS=new B(0,0,0),eM=new B(1,1,1),$s=new B,Wl=new B,mi=new B,pm=new vt,mm=new At,Ci=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(St(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-St(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(St(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-St(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(St(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-St(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return pm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(pm,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return mm.setFromEuler(this),this.setFromQuaternion(mm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ci.DEFAULT_ORDER="XYZ";var Ao=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},tM=0,gm=new B,lo=new At,Ms=new vt,Xl=new B,fa=new B,nM=new B,iM=new At,_m=new B(1,0,0),xm=new B(0,1,0),vm=new B(0,0,1),ym={type:"added"},sM={type:"removed"},co={type:"childadded",child:null},Jh={type:"childremoved",child:null},pn=class n extends Hi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:tM++}),this.uuid=Ka(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new B,t=new Ci,i=new At,s=new B(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new vt},normalMatrix:{value:new nt}}),this.matrix=new vt,this.matrixWorld=new vt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ao,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return lo.setFromAxisAngle(e,t),this.quaternion.multiply(lo),this}rotateOnWorldAxis(e,t){return lo.setFromAxisAngle(e,t),this.quaternion.premultiply(lo),this}rotateX(e){return this.rotateOnAxis(_m,e)}rotateY(e){return this.rotateOnAxis(xm,e)}rotateZ(e){return this.rotateOnAxis(vm,e)}translateOnAxis(e,t){return gm.copy(e).applyQuaternion(this.quaternion),this.position.add(gm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(_m,e)}translateY(e){return this.translateOnAxis(xm,e)}translateZ(e){return this.translateOnAxis(vm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ms.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Xl.copy(e):Xl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),fa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ms.lookAt(fa,Xl,this.up):Ms.lookAt(Xl,fa,this.up),this.quaternion.setFromRotationMatrix(Ms),s&&(Ms.extractRotation(s.matrixWorld),lo.setFromRotationMatrix(Ms),this.quaternion.premultiply(lo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(et("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(ym),co.child=e,this.dispatchEvent(co),co.child=null):et("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(sM),Jh.child=e,this.dispatchEvent(Jh),Jh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ms.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ms.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ms),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(ym),co.child=e,this.dispatchEvent(co),co.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(fa,e,nM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(fa,iM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),p=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),p.length>0&&(i.animations=p),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};pn.DEFAULT_UP=new B(0,1,0);pn.DEFAULT_MATRIX_AUTO_UPDATE=!0;pn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ln=class extends pn{constructor(){super(),this.isGroup=!0,this.type="Group"}},rM={type:"move"},To=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ln,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ln,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ln,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let d=t.getJointPose(y,i),m=this._getHandJoint(c,y);d!==null&&(m.matrix.fromArray(d.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=d.radius),m.visible=d!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),p=.02,g=.005;c.inputState.pinching&&h>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(rM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new ln;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Eg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Zs={h:0,s:0,l:0},ql={h:0,s:0,l:0};function jh(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Ye=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Qn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=i,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=xt.workingColorSpace){if(e=YS(e,1),t=St(t,0,1),i=St(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=jh(o,r,e+1/3),this.g=jh(o,r,e),this.b=jh(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=Qn){function i(r){r!==void 0&&parseFloat(r)<1&&Je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Qn){let i=Eg[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ts(e.r),this.g=Ts(e.g),this.b=Ts(e.b),this}copyLinearToSRGB(e){return this.r=So(e.r),this.g=So(e.g),this.b=So(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Qn){return xt.workingToColorSpace(Hn.copy(this),e),Math.round(St(Hn.r*255,0,255))*65536+Math.round(St(Hn.g*255,0,255))*256+Math.round(St(Hn.b*255,0,255))}getHexString(e=Qn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(Hn.copy(this),t);let i=Hn.r,s=Hn.g,r=Hn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(Hn.copy(this),t),e.r=Hn.r,e.g=Hn.g,e.b=Hn.b,e}getStyle(e=Qn){xt.workingToColorSpace(Hn.copy(this),e);let t=Hn.r,i=Hn.g,s=Hn.b;return e!==Qn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Zs),this.setHSL(Zs.h+e,Zs.s+t,Zs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Zs),e.getHSL(ql);let i=Xh(Zs.h,ql.h,t),s=Xh(Zs.s,ql.s,t),r=Xh(Zs.l,ql.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Hn=new Ye;Ye.NAMES=Eg;var Ea=class extends pn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ci,this.environmentIntensity=1,this.environmentRotation=new Ci,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},zi=new B,bs=new B,Kh=new B,ws=new B,uo=new B,ho=new B,Sm=new B,Qh=new B,ef=new B,tf=new B,nf=new Ht,sf=new Ht,rf=new Ht,Qs=class n{constructor(e=new B,t=new B,i=new B){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),zi.subVectors(e,t),s.cross(zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){zi.subVectors(s,t),bs.subVectors(i,t),Kh.subVectors(e,t);let o=zi.dot(zi),a=zi.dot(bs),l=zi.dot(Kh),c=bs.dot(bs),u=bs.dot(Kh),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,p=(c*l-a*u)*h,g=(o*u-a*l)*h;return r.set(1-p-g,g,p)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,ws)===null?!1:ws.x>=0&&ws.y>=0&&ws.x+ws.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,ws)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ws.x),l.addScaledVector(o,ws.y),l.addScaledVector(a,ws.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return nf.setScalar(0),sf.setScalar(0),rf.setScalar(0),nf.fromBufferAttribute(e,t),sf.fromBufferAttribute(e,i),rf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(nf,r.x),o.addScaledVector(sf,r.y),o.addScaledVector(rf,r.z),o}static isFrontFacing(e,t,i,s){return zi.subVectors(i,t),bs.subVectors(e,t),zi.cross(bs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return zi.subVectors(this.c,this.b),bs.subVectors(this.a,this.b),zi.cross(bs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;uo.subVectors(s,i),ho.subVectors(r,i),Qh.subVectors(e,i);let l=uo.dot(Qh),c=ho.dot(Qh);if(l<=0&&c<=0)return t.copy(i);ef.subVectors(e,s);let u=uo.dot(ef),f=ho.dot(ef);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(uo,o);tf.subVectors(e,r);let p=uo.dot(tf),g=ho.dot(tf);if(g>=0&&p<=g)return t.copy(r);let y=p*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(ho,a);let d=u*g-p*f;if(d<=0&&f-u>=0&&p-g>=0)return Sm.subVectors(r,s),a=(f-u)/(f-u+(p-g)),t.copy(s).addScaledVector(Sm,a);let m=1/(d+y+h);return o=y*m,a=h*m,t.copy(i).addScaledVector(uo,o).addScaledVector(ho,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},us=class{constructor(e=new B(1/0,1/0,1/0),t=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Gi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Gi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Gi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Gi):Gi.fromBufferAttribute(r,o),Gi.applyMatrix4(e.matrixWorld),this.expandByPoint(Gi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Yl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Yl.copy(i.boundingBox)),Yl.applyMatrix4(e.matrixWorld),this.union(Yl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Gi),Gi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(da),$l.subVectors(this.max,da),fo.subVectors(e.a,da),po.subVectors(e.b,da),mo.subVectors(e.c,da),Js.subVectors(po,fo),js.subVectors(mo,po),yr.subVectors(fo,mo);let t=[0,-Js.z,Js.y,0,-js.z,js.y,0,-yr.z,yr.y,Js.z,0,-Js.x,js.z,0,-js.x,yr.z,0,-yr.x,-Js.y,Js.x,0,-js.y,js.x,0,-yr.y,yr.x,0];return!of(t,fo,po,mo,$l)||(t=[1,0,0,0,1,0,0,0,1],!of(t,fo,po,mo,$l))?!1:(Zl.crossVectors(Js,js),t=[Zl.x,Zl.y,Zl.z],of(t,fo,po,mo,$l))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Gi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Gi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Es[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Es[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Es[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Es[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Es[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Es[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Es[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Es[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Es),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Es=[new B,new B,new B,new B,new B,new B,new B,new B],Gi=new B,Yl=new us,fo=new B,po=new B,mo=new B,Js=new B,js=new B,yr=new B,da=new B,$l=new B,Zl=new B,Sr=new B;function of(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Sr.fromArray(n,r);let a=s.x*Math.abs(Sr.x)+s.y*Math.abs(Sr.y)+s.z*Math.abs(Sr.z),l=e.dot(Sr),c=t.dot(Sr),u=i.dot(Sr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Mn=new B,Jl=new ct,oM=0,dn=class extends Hi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:oM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=vg,this.updateRanges=[],this.gpuType=Pi,this.version=0,this._normalizationScale=e!==void 0?qf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Jl.fromBufferAttribute(this,t),Jl.applyMatrix3(e),this.setXY(t,Jl.x,Jl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Mn.fromBufferAttribute(this,t),Mn.applyMatrix3(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Mn.fromBufferAttribute(this,t),Mn.applyMatrix4(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Mn.fromBufferAttribute(this,t),Mn.applyNormalMatrix(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Mn.fromBufferAttribute(this,t),Mn.transformDirection(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):$S(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):ZS(e,this.array)}};var Aa=class extends dn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Ta=class extends dn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Dt=class extends dn{constructor(e,t,i){super(new Float32Array(e),t,i)}},aM=new us,pa=new B,af=new B,Rs=class{constructor(e=new B,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):aM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;pa.subVectors(e,this.center);let t=pa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(pa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(af.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(pa.copy(e.center).add(af)),this.expandByPoint(pa.copy(e.center).sub(af))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},lM=0,Ai=new vt,lf=new pn,go=new B,gi=new us,ma=new us,Fn=new B,mn=class n extends Hi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:lM++}),this.uuid=Ka(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(XS(e)?Ta:Aa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new nt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ai.makeRotationFromQuaternion(e),this.applyMatrix4(Ai),this}rotateX(e){return Ai.makeRotationX(e),this.applyMatrix4(Ai),this}rotateY(e){return Ai.makeRotationY(e),this.applyMatrix4(Ai),this}rotateZ(e){return Ai.makeRotationZ(e),this.applyMatrix4(Ai),this}translate(e,t,i){return Ai.makeTranslation(e,t,i),this.applyMatrix4(Ai),this}scale(e,t,i){return Ai.makeScale(e,t,i),this.applyMatrix4(Ai),this}lookAt(e){return lf.lookAt(e),lf.updateMatrix(),this.applyMatrix4(lf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(go).negate(),this.translate(go.x,go.y,go.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Dt(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new us);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];gi.setFromBufferAttribute(r),this.morphTargetsRelative?(Fn.addVectors(this.boundingBox.min,gi.min),this.boundingBox.expandByPoint(Fn),Fn.addVectors(this.boundingBox.max,gi.max),this.boundingBox.expandByPoint(Fn)):(this.boundingBox.expandByPoint(gi.min),this.boundingBox.expandByPoint(gi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&et('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Rs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){et("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(e){let i=this.boundingSphere.center;if(gi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ma.setFromBufferAttribute(a),this.morphTargetsRelative?(Fn.addVectors(gi.min,ma.min),gi.expandByPoint(Fn),Fn.addVectors(gi.max,ma.max),gi.expandByPoint(Fn)):(gi.expandByPoint(ma.min),gi.expandByPoint(ma.max))}gi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Fn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Fn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Fn.fromBufferAttribute(a,c),l&&(go.fromBufferAttribute(e,c),Fn.add(go)),s=Math.max(s,i.distanceToSquared(Fn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&et('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){et("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new dn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new B,l[U]=new B;let u=new B,f=new B,h=new B,p=new ct,g=new ct,y=new ct,d=new B,m=new B;function v(U,L,I){c[U]=c[L]=c[I]=1,u.fromBufferAttribute(i,U),f.fromBufferAttribute(i,L),h.fromBufferAttribute(i,I),p.fromBufferAttribute(r,U),g.fromBufferAttribute(r,L),y.fromBufferAttribute(r,I),f.sub(u),h.sub(u),g.sub(p),y.sub(p);let k=1/(g.x*y.y-y.x*g.y);isFinite(k)&&(d.copy(f).multiplyScalar(y.y).addScaledVector(h,-g.y).multiplyScalar(k),m.copy(h).multiplyScalar(g.x).addScaledVector(f,-y.x).multiplyScalar(k),a[U].add(d),a[L].add(d),a[I].add(d),l[U].add(m),l[L].add(m),l[I].add(m))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let U=0,L=T.length;U<L;++U){let I=T[U],k=I.start,W=I.count;for(let N=k,V=k+W;N<V;N+=3)v(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new B,C=new B,A=new B,_=new B;function w(U){A.fromBufferAttribute(s,U),_.copy(A);let L=a[U];S.copy(L),S.sub(A.multiplyScalar(A.dot(L))).normalize(),C.crossVectors(_,L);let k=C.dot(l[U])<0?-1:1;o.setXYZW(U,S.x,S.y,S.z,k)}for(let U=0,L=i.count;U<L;++U)c[U]&&w(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new dn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,p=i.count;h<p;h++)i.setXYZ(h,0,0,0);let s=new B,r=new B,o=new B,a=new B,l=new B,c=new B,u=new B,f=new B;if(e)for(let h=0,p=e.count;h<p;h+=3){let g=e.getX(h+0),y=e.getX(h+1),d=e.getX(h+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,d),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,d),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(d,c.x,c.y,c.z)}else for(let h=0,p=t.count;h<p;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Fn.fromBufferAttribute(e,t),Fn.normalize(),e.setXYZ(t,Fn.x,Fn.y,Fn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),p=0,g=0;for(let y=0,d=l.length;y<d;y++){a.isInterleavedBufferAttribute?p=l[y]*a.data.stride+a.offset:p=l[y]*u;for(let m=0;m<u;m++)h[g++]=c[p++]}return new dn(h,u,f)}if(this.index===null)return Je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],p=e(h,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let p=c[f];u.push(p.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,p=f.length;h<p;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var cf=new B,cM=new B,uM=new nt,Vi=class{constructor(e=new B(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=cf.subVectors(i,t).cross(cM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(cf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||uM.getNormalMatrix(e),s=this.coplanarPoint(cf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},hM=0,Wi=class extends Hi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:hM++}),this.uuid=Ka(),this.name="",this.type="Material",this.blending=No,this.side=or,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Af,this.blendDst=Tf,this.blendEquation=Cr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ye(0,0,0),this.blendAlpha=0,this.depthFunc=Mo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=dg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=pc,this.stencilZFail=pc,this.stencilZPass=pc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ye().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Vi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new ct().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ct().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var As=new B,uf=new B,jl=new B,Kl=new B,Co=class{constructor(e=new B,t=new B(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,As)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=As.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(As.copy(this.origin).addScaledVector(this.direction,t),As.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){uf.copy(e).add(t).multiplyScalar(.5),jl.copy(t).sub(e).normalize(),Kl.copy(this.origin).sub(uf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(jl),a=Kl.dot(this.direction),l=-Kl.dot(jl),c=Kl.lengthSq(),u=Math.abs(1-o*o),f,h,p,g;if(u>0)if(f=o*l-a,h=o*a-l,g=r*u,f>=0)if(h>=-g)if(h<=g){let y=1/u;f*=y,h*=y,p=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;else h<=-g?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),p=-f*f+h*(h+2*l)+c):h<=g?(f=0,h=Math.min(Math.max(-r,-l),r),p=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),p=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),p=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(uf).addScaledVector(jl,h),p}intersectSphere(e,t){if(e.radius<0)return null;As.subVectors(e.center,this.origin);let i=As.dot(this.direction),s=As.dot(As)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,As)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,p=e.z-o.z,g=t.x-o.x,y=t.y-o.y,d=t.z-o.z,m=i.x-o.x,v=i.y-o.y,T=i.z-o.z,S=Math.abs(l),C=Math.abs(c),A=Math.abs(u),_,w,U,L,I,k,W,N,V,Y,G,ae;if(S>=C&&S>=A?(U=l,k=f,V=g,ae=m,l>=0?(_=c,w=u,L=h,I=p,W=y,N=d,Y=v,G=T):(_=u,w=c,L=p,I=h,W=d,N=y,Y=T,G=v)):C>=A?(U=c,k=h,V=y,ae=v,c>=0?(_=u,w=l,L=p,I=f,W=d,N=g,Y=T,G=m):(_=l,w=u,L=f,I=p,W=g,N=d,Y=m,G=T)):(U=u,k=p,V=d,ae=T,u>=0?(_=l,w=c,L=f,I=h,W=g,N=y,Y=m,G=v):(_=c,w=l,L=h,I=f,W=y,N=g,Y=v,G=m)),U===0)return null;let q=_/U,K=w/U,ne=1/U,he=L-q*k,fe=I-K*k,Q=W-q*V,ge=N-K*V,ve=Y-q*ae,Re=G-K*ae,we=ve*ge-Re*Q,Xe=he*Re-fe*ve,ot=Q*fe-ge*he;if(s){if(we<0||Xe<0||ot<0)return null}else if((we<0||Xe<0||ot<0)&&(we>0||Xe>0||ot>0))return null;let He=we+Xe+ot;if(He===0)return null;let dt=ne*(we*k+Xe*V+ot*ae);return(He>0?dt<0:dt>0)?null:this.at(dt/He,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Xi=class extends Wi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ye(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ci,this.combine=$c,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Mm=new vt,Mr=new Co,Ql=new Rs,bm=new B,ec=new B,tc=new B,nc=new B,hf=new B,ic=new B,wm=new B,sc=new B,be=class extends pn{constructor(e=new mn,t=new Xi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){ic.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(hf.fromBufferAttribute(f,e),o?ic.addScaledVector(hf,u):ic.addScaledVector(hf.sub(t),u))}t.add(ic)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Ql.copy(i.boundingSphere),Ql.applyMatrix4(r),Mr.copy(e.ray).recast(e.near),!(Ql.containsPoint(Mr.origin)===!1&&(Mr.intersectSphere(Ql,bm)===null||Mr.origin.distanceToSquared(bm)>(e.far-e.near)**2))&&(Mm.copy(r).invert(),Mr.copy(e.ray).applyMatrix4(Mm),!(i.boundingBox!==null&&Mr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Mr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=h.length;g<y;g++){let d=h[g],m=o[d.materialIndex],v=Math.max(d.start,p.start),T=Math.min(a.count,Math.min(d.start+d.count,p.start+p.count));for(let S=v,C=T;S<C;S+=3){let A=a.getX(S),_=a.getX(S+1),w=a.getX(S+2);s=rc(this,m,e,i,c,u,f,A,_,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=d.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),y=Math.min(a.count,p.start+p.count);for(let d=g,m=y;d<m;d+=3){let v=a.getX(d),T=a.getX(d+1),S=a.getX(d+2);s=rc(this,o,e,i,c,u,f,v,T,S),s&&(s.faceIndex=Math.floor(d/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=h.length;g<y;g++){let d=h[g],m=o[d.materialIndex],v=Math.max(d.start,p.start),T=Math.min(l.count,Math.min(d.start+d.count,p.start+p.count));for(let S=v,C=T;S<C;S+=3){let A=S,_=S+1,w=S+2;s=rc(this,m,e,i,c,u,f,A,_,w),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=d.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),y=Math.min(l.count,p.start+p.count);for(let d=g,m=y;d<m;d+=3){let v=d,T=d+1,S=d+2;s=rc(this,o,e,i,c,u,f,v,T,S),s&&(s.faceIndex=Math.floor(d/3),t.push(s))}}}};function fM(n,e,t,i,s,r,o,a){let l;if(e.side===ni?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===or,a),l===null)return null;sc.copy(a),sc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(sc);return c<t.near||c>t.far?null:{distance:c,point:sc.clone(),object:n}}function rc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,ec),n.getVertexPosition(l,tc),n.getVertexPosition(c,nc);let u=fM(n,e,t,i,ec,tc,nc,wm);if(u){let f=new B;Qs.getBarycoord(wm,ec,tc,nc,f),s&&(u.uv=Qs.getInterpolatedAttribute(s,a,l,c,f,new ct)),r&&(u.uv1=Qs.getInterpolatedAttribute(r,a,l,c,f,new ct)),o&&(u.normal=Qs.getInterpolatedAttribute(o,a,l,c,f,new B),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new B,materialIndex:0};Qs.getNormal(ec,tc,nc,h.normal),u.face=h,u.barycoord=f}return u}var wr=class extends oi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=On,u=On,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ca=class extends dn{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},_o=new vt,Em=new vt,oc=[],Am=new us,dM=new vt,ga=new be,_a=new Rs,Ra=class extends be{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Ca(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,dM)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new us),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,_o),Am.copy(e.boundingBox).applyMatrix4(_o),this.boundingBox.union(Am)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Rs),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,_o),_a.copy(e.boundingSphere).applyMatrix4(_o),this.boundingSphere.union(_a)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(ga.geometry=this.geometry,ga.material=this.material,ga.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),_a.copy(this.boundingSphere),_a.applyMatrix4(i),e.ray.intersectsSphere(_a)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,_o),Em.multiplyMatrices(i,_o),ga.matrixWorld=Em,ga.raycast(e,oc);for(let o=0,a=oc.length;o<a;o++){let l=oc[o];l.instanceId=r,l.object=this,t.push(l)}oc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Ca(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new wr(new Float32Array(s*this.count),s,this.count,Fo,Pi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},br=new Rs,pM=new ct(.5,.5),ac=new B,er=class{constructor(e=new Vi,t=new Vi,i=new Vi,s=new Vi,r=new Vi,o=new Vi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ti,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],p=r[7],g=r[8],y=r[9],d=r[10],m=r[11],v=r[12],T=r[13],S=r[14],C=r[15];if(s[0].setComponents(c-o,p-u,m-g,C-v).normalize(),s[1].setComponents(c+o,p+u,m+g,C+v).normalize(),s[2].setComponents(c+a,p+f,m+y,C+T).normalize(),s[3].setComponents(c-a,p-f,m-y,C-T).normalize(),i)s[4].setComponents(l,h,d,S).normalize(),s[5].setComponents(c-l,p-h,m-d,C-S).normalize();else if(s[4].setComponents(c-l,p-h,m-d,C-S).normalize(),t===Ti)s[5].setComponents(c+l,p+h,m+d,C+S).normalize();else if(t===bo)s[5].setComponents(l,h,d,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),br.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),br.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(br)}intersectsSprite(e){br.center.set(0,0,0);let t=pM.distanceTo(e.center);return br.radius=.7071067811865476+t,br.applyMatrix4(e.matrixWorld),this.intersectsSphere(br)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(ac.x=s.normal.x>0?e.max.x:e.min.x,ac.y=s.normal.y>0?e.max.y:e.min.y,ac.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(ac)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Tm=new vt,Rc=class n{constructor(){this.coordinateSystem=Ti,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Tm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new er),i[s].setFromProjectionMatrix(Tm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new er),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var tr=class extends Wi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ye(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Pc=new B,Ic=new B,Cm=new vt,xa=new Co,lc=new Rs,ff=new B,Rm=new B,xi=class extends pn{constructor(e=new mn,t=new tr){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Pc.fromBufferAttribute(t,s-1),Ic.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Pc.distanceTo(Ic);e.setAttribute("lineDistance",new Dt(i,1))}else Je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),lc.copy(i.boundingSphere),lc.applyMatrix4(s),lc.radius+=r,e.ray.intersectsSphere(lc)===!1)return;Cm.copy(s).invert(),xa.copy(e.ray).applyMatrix4(Cm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=p,d=g-1;y<d;y+=c){let m=u.getX(y),v=u.getX(y+1),T=cc(this,e,xa,l,m,v,y);T&&t.push(T)}if(this.isLineLoop){let y=u.getX(g-1),d=u.getX(p),m=cc(this,e,xa,l,y,d,g-1);m&&t.push(m)}}else{let p=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=p,d=g-1;y<d;y+=c){let m=cc(this,e,xa,l,y,y+1,y);m&&t.push(m)}if(this.isLineLoop){let y=cc(this,e,xa,l,g-1,p,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function cc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Pc.fromBufferAttribute(a,s),Ic.fromBufferAttribute(a,r),t.distanceSqToSegment(Pc,Ic,ff,Rm)>i)return;ff.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(ff);if(!(c<e.near||c>e.far))return{distance:c,point:Rm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Pm=new B,Im=new B,Pa=class extends xi{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)Pm.fromBufferAttribute(t,s),Im.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Pm.distanceTo(Im);e.setAttribute("lineDistance",new Dt(i,1))}else Je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ia=class extends oi{constructor(e=[],t=Rr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ps=class extends oi{constructor(e,t,i=Yi,s,r,o,a=On,l=On,c,u=Cs,f=1){if(u!==Cs&&u!==Ds)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Eo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},La=class extends Ps{constructor(e,t=Yi,i=Rr,s,r,o=On,a=On,l,c=Cs){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Na=class extends oi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},cn=class n extends mn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,p=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Dt(c,3)),this.setAttribute("normal",new Dt(u,3)),this.setAttribute("uv",new Dt(f,2));function g(y,d,m,v,T,S,C,A,_,w,U){let L=S/_,I=C/w,k=S/2,W=C/2,N=A/2,V=_+1,Y=w+1,G=0,ae=0,q=new B;for(let K=0;K<Y;K++){let ne=K*I-W;for(let he=0;he<V;he++){let fe=he*L-k;q[y]=fe*v,q[d]=ne*T,q[m]=N,c.push(q.x,q.y,q.z),q[y]=0,q[d]=0,q[m]=A>0?1:-1,u.push(q.x,q.y,q.z),f.push(he/_),f.push(1-K/w),G+=1}}for(let K=0;K<w;K++)for(let ne=0;ne<_;ne++){let he=h+ne+V*K,fe=h+ne+V*(K+1),Q=h+(ne+1)+V*(K+1),ge=h+(ne+1)+V*K;l.push(he,fe,ge),l.push(fe,Q,ge),ae+=6}a.addGroup(p,ae,U),p+=ae,h+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Wt=class n extends mn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],f=[],h=[],p=[],g=0,y=[],d=i/2,m=0;v(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new Dt(f,3)),this.setAttribute("normal",new Dt(h,3)),this.setAttribute("uv",new Dt(p,2));function v(){let S=new B,C=new B,A=0,_=(t-e)/i;for(let w=0;w<=r;w++){let U=[],L=w/r,I=L*(t-e)+e;for(let k=0;k<=s;k++){let W=k/s,N=W*l+a,V=Math.sin(N),Y=Math.cos(N);C.x=I*V,C.y=-L*i+d,C.z=I*Y,f.push(C.x,C.y,C.z),S.set(V,_,Y).normalize(),h.push(S.x,S.y,S.z),p.push(W,1-L),U.push(g++)}y.push(U)}for(let w=0;w<s;w++)for(let U=0;U<r;U++){let L=y[U][w],I=y[U+1][w],k=y[U+1][w+1],W=y[U][w+1];(e>0||U!==0)&&(u.push(L,I,W),A+=3),(t>0||U!==r-1)&&(u.push(I,k,W),A+=3)}c.addGroup(m,A,0),m+=A}function T(S){let C=g,A=new ct,_=new B,w=0,U=S===!0?e:t,L=S===!0?1:-1;for(let k=1;k<=s;k++)f.push(0,d*L,0),h.push(0,L,0),p.push(.5,.5),g++;let I=g;for(let k=0;k<=s;k++){let N=k/s*l+a,V=Math.cos(N),Y=Math.sin(N);_.x=U*Y,_.y=d*L,_.z=U*V,f.push(_.x,_.y,_.z),h.push(0,L,0),A.x=V*.5+.5,A.y=Y*.5*L+.5,p.push(A.x,A.y),g++}for(let k=0;k<s;k++){let W=C+k,N=I+k;S===!0?u.push(N,N+1,W):u.push(N+1,N,W),w+=3}c.addGroup(m,w,S===!0?1:2),m+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Is=class n extends Wt{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Lc=class n extends mn{constructor(e=[],t=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new Dt(r,3)),this.setAttribute("normal",new Dt(r.slice(),3)),this.setAttribute("uv",new Dt(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(v){let T=new B,S=new B,C=new B;for(let A=0;A<t.length;A+=3)p(t[A+0],T),p(t[A+1],S),p(t[A+2],C),l(T,S,C,v)}function l(v,T,S,C){let A=C+1,_=[];for(let w=0;w<=A;w++){_[w]=[];let U=v.clone().lerp(S,w/A),L=T.clone().lerp(S,w/A),I=A-w;for(let k=0;k<=I;k++)k===0&&w===A?_[w][k]=U:_[w][k]=U.clone().lerp(L,k/I)}for(let w=0;w<A;w++)for(let U=0;U<2*(A-w)-1;U++){let L=Math.floor(U/2);U%2===0?(h(_[w][L+1]),h(_[w+1][L]),h(_[w][L])):(h(_[w][L+1]),h(_[w+1][L+1]),h(_[w+1][L]))}}function c(v){let T=new B;for(let S=0;S<r.length;S+=3)T.x=r[S+0],T.y=r[S+1],T.z=r[S+2],T.normalize().multiplyScalar(v),r[S+0]=T.x,r[S+1]=T.y,r[S+2]=T.z}function u(){let v=new B;for(let T=0;T<r.length;T+=3){v.x=r[T+0],v.y=r[T+1],v.z=r[T+2];let S=d(v)/2/Math.PI+.5,C=m(v)/Math.PI+.5;o.push(S,1-C)}g(),f()}function f(){for(let v=0;v<o.length;v+=6){let T=o[v+0],S=o[v+2],C=o[v+4],A=Math.max(T,S,C),_=Math.min(T,S,C);A>.9&&_<.1&&(T<.2&&(o[v+0]+=1),S<.2&&(o[v+2]+=1),C<.2&&(o[v+4]+=1))}}function h(v){r.push(v.x,v.y,v.z)}function p(v,T){let S=v*3;T.x=e[S+0],T.y=e[S+1],T.z=e[S+2]}function g(){let v=new B,T=new B,S=new B,C=new B,A=new ct,_=new ct,w=new ct;for(let U=0,L=0;U<r.length;U+=9,L+=6){v.set(r[U+0],r[U+1],r[U+2]),T.set(r[U+3],r[U+4],r[U+5]),S.set(r[U+6],r[U+7],r[U+8]),A.set(o[L+0],o[L+1]),_.set(o[L+2],o[L+3]),w.set(o[L+4],o[L+5]),C.copy(v).add(T).add(S).divideScalar(3);let I=d(C);y(A,L+0,v,I),y(_,L+2,T,I),y(w,L+4,S,I)}}function y(v,T,S,C){C<0&&v.x===1&&(o[T]=v.x-1),S.x===0&&S.z===0&&(o[T]=C/2/Math.PI+.5)}function d(v){return Math.atan2(v.z,-v.x)}function m(v){return Math.atan2(-v.y,Math.sqrt(v.x*v.x+v.z*v.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.vertices,e.indices,e.radius,e.detail)}};var nr=class n extends Lc{constructor(e=1,t=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,e,t),this.type="OctahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new n(e.radius,e.detail)}},Ls=class n extends mn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,p=[],g=[],y=[],d=[];for(let m=0;m<u;m++){let v=m*h-o;for(let T=0;T<c;T++){let S=T*f-r;g.push(S,-v,0),y.push(0,0,1),d.push(T/a),d.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let T=v+c*m,S=v+c*(m+1),C=v+1+c*(m+1),A=v+1+c*m;p.push(T,S,A),p.push(S,C,A)}this.setIndex(p),this.setAttribute("position",new Dt(g,3)),this.setAttribute("normal",new Dt(y,3)),this.setAttribute("uv",new Dt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var hs=class n extends mn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],f=new B,h=new B,p=[],g=[],y=[],d=[];for(let m=0;m<=i;m++){let v=[],T=m/i,S=o+T*a,C=e*Math.cos(S),A=Math.sqrt(e*e-C*C),_=0;m===0&&o===0?_=.5/t:m===i&&l===Math.PI&&(_=-.5/t);for(let w=0;w<=t;w++){let U=w/t,L=s+U*r;f.x=-A*Math.cos(L),f.y=C,f.z=A*Math.sin(L),g.push(f.x,f.y,f.z),h.copy(f).normalize(),y.push(h.x,h.y,h.z),d.push(U+_,1-T),v.push(c++)}u.push(v)}for(let m=0;m<i;m++)for(let v=0;v<t;v++){let T=u[m][v+1],S=u[m][v],C=u[m+1][v],A=u[m+1][v+1];(m!==0||o>0)&&p.push(T,S,A),(m!==i-1||l<Math.PI)&&p.push(S,C,A)}this.setIndex(p),this.setAttribute("position",new Dt(g,3)),this.setAttribute("normal",new Dt(y,3)),this.setAttribute("uv",new Dt(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var qi=class n extends mn{constructor(e=1,t=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],f=[],h=new B,p=new B,g=new B;for(let y=0;y<=i;y++){let d=o+y/i*a;for(let m=0;m<=s;m++){let v=m/s*r;p.x=(e+t*Math.cos(d))*Math.cos(v),p.y=(e+t*Math.cos(d))*Math.sin(v),p.z=t*Math.sin(d),c.push(p.x,p.y,p.z),h.x=e*Math.cos(v),h.y=e*Math.sin(v),g.subVectors(p,h).normalize(),u.push(g.x,g.y,g.z),f.push(m/s),f.push(y/i)}}for(let y=1;y<=i;y++)for(let d=1;d<=s;d++){let m=(s+1)*y+d-1,v=(s+1)*(y-1)+d-1,T=(s+1)*(y-1)+d,S=(s+1)*y+d;l.push(m,v,S),l.push(v,T,S)}this.setIndex(l),this.setAttribute("position",new Dt(c,3)),this.setAttribute("normal",new Dt(u,3)),this.setAttribute("uv",new Dt(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var Da=class extends Wi{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Ye(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function Ir(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(Lm(s))s.isRenderTargetTexture?(Je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Lm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Xn(n){let e={};for(let t=0;t<n.length;t++){let i=Ir(n[t]);for(let s in i)e[s]=i[s]}return e}function Lm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function mM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Yf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var Ag={clone:Ir,merge:Xn},gM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,_M=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ai=class extends Wi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=gM,this.fragmentShader=_M,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ir(e.uniforms),this.uniformsGroups=mM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new Ye().setHex(s.value);break;case"v2":this.uniforms[i].value=new ct().fromArray(s.value);break;case"v3":this.uniforms[i].value=new B().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Ht().fromArray(s.value);break;case"m3":this.uniforms[i].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new vt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Nc=class extends ai{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Ua=class extends Wi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Ye(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ye(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ja,this.normalScale=new ct(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ci,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Fa=class extends Wi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ye(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ye(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ja,this.normalScale=new ct(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ci,this.combine=$c,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Dc=class extends Wi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=hg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Uc=class extends Wi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function xo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function uc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var ir=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Fc=class extends ir{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:mf,endingEnd:mf}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case gf:r=e,a=2*t-i;break;case _f:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case gf:o=e,l=2*i-t;break;case _f:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,p=this._weightNext,g=(i-t)/(s-t),y=g*g,d=y*g,m=-h*d+2*h*y-h*g,v=(1+h)*d+(-1.5-2*h)*y+(-.5+h)*g+1,T=(-1-p)*d+(1.5+p)*y+.5*g,S=p*d-p*y;for(let C=0;C!==a;++C)r[C]=m*o[u+C]+v*o[c+C]+T*o[l+C]+S*o[f+C];return r}},Oc=class extends ir{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},Bc=class extends ir{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},kc=class extends ir{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let g=(i-t)/(s-t),y=1-g;for(let d=0;d!==a;++d)r[d]=o[c+d]*y+o[l+d]*g;return r}let h=a*2,p=e-1;for(let g=0;g!==a;++g){let y=o[c+g],d=o[l+g],m=p*h+g*2,v=f[m],T=f[m+1],S=e*h+g*2,C=u[S],A=u[S+1],_=vM(i,t,v,C,s);r[g]=Tg(_,y,T,A,d)}return r}};function Tg(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function xM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function vM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=Tg(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=xM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var vi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=xo(t,this.TimeBufferType),this.values=xo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:xo(e.times,Array),values:xo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),uc(e.settings)&&(i.settings={inTangents:xo(e.settings.inTangents,Array),outTangents:xo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Bc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Oc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Fc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new kc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ya:t=this.InterpolantFactoryMethodDiscrete;break;case wc:t=this.InterpolantFactoryMethodLinear;break;case dc:t=this.InterpolantFactoryMethodSmooth;break;case pf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ya;case this.InterpolantFactoryMethodLinear:return wc;case this.InterpolantFactoryMethodSmooth:return dc;case this.InterpolantFactoryMethodBezier:return pf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;uc(this.settings)&&(Nm(this.settings.inTangents,e),Nm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;uc(this.settings)&&(Dm(this.settings.inTangents,e),Dm(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(et("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(et("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){et("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){et("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&qS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){et("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===dc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,p=f+i;for(let g=0;g!==i;++g){let y=t[f+g];if(y!==t[h+g]||y!==t[p+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let p=0;p!==i;++p)t[h+p]=t[f+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,uc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Nm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Dm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}vi.prototype.ValueTypeName="";vi.prototype.TimeBufferType=Float32Array;vi.prototype.ValueBufferType=Float32Array;vi.prototype.DefaultInterpolation=wc;var sr=class extends vi{constructor(e,t,i){super(e,t,i)}};sr.prototype.ValueTypeName="bool";sr.prototype.ValueBufferType=Array;sr.prototype.DefaultInterpolation=ya;sr.prototype.InterpolantFactoryMethodLinear=void 0;sr.prototype.InterpolantFactoryMethodSmooth=void 0;var zc=class extends vi{constructor(e,t,i,s){super(e,t,i,s)}};zc.prototype.ValueTypeName="color";var Gc=class extends vi{constructor(e,t,i,s){super(e,t,i,s)}};Gc.prototype.ValueTypeName="number";var Vc=class extends ir{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)At.slerpFlat(r,0,o,c-a,o,c,l);return r}},Oa=class extends vi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Vc(this.times,this.values,this.getValueSize(),e)}};Oa.prototype.ValueTypeName="quaternion";Oa.prototype.InterpolantFactoryMethodSmooth=void 0;var rr=class extends vi{constructor(e,t,i){super(e,t,i)}};rr.prototype.ValueTypeName="string";rr.prototype.ValueBufferType=Array;rr.prototype.DefaultInterpolation=ya;rr.prototype.InterpolantFactoryMethodLinear=void 0;rr.prototype.InterpolantFactoryMethodSmooth=void 0;var Hc=class extends vi{constructor(e,t,i,s){super(e,t,i,s)}};Hc.prototype.ValueTypeName="vector";var Wc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let p=c[f],g=c[f+1];if(p.global&&(p.lastIndex=0),p.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Cg=new Wc,Xc=class{constructor(e){this.manager=e!==void 0?e:Cg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Xc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ro=class extends pn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Ye(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Ba=class extends Ro{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(pn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ye(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},df=new vt,Um=new B,Fm=new B,qc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ct(512,512),this.mapType=Wn,this.map=null,this.mapPass=null,this.matrix=new vt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new er,this._frameExtents=new ct(1,1),this._viewportCount=1,this._viewports=[new Ht(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Um.setFromMatrixPosition(e.matrixWorld),t.position.copy(Um),Fm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Fm),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){df.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(df,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===bo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(df)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},hc=new B,fc=new At,ls=new B,ka=class extends pn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new vt,this.projectionMatrix=new vt,this.projectionMatrixInverse=new vt,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(hc,fc,ls),ls.x===1&&ls.y===1&&ls.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(hc,fc,ls.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(hc,fc,ls),ls.x===1&&ls.y===1&&ls.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(hc,fc,ls.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ks=new B,Om=new ct,Bm=new ct,ei=class extends ka{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ec*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Wh*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ec*2*Math.atan(Math.tan(Wh*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Ks.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ks.x,Ks.y).multiplyScalar(-e/Ks.z),Ks.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ks.x,Ks.y).multiplyScalar(-e/Ks.z)}getViewSize(e,t){return this.getViewBounds(e,Om,Bm),t.subVectors(Bm,Om)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Wh*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var za=class extends ka{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},xf=class extends qc{constructor(){super(new za(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Po=class extends Ro{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(pn.DEFAULT_UP),this.updateMatrix(),this.target=new pn,this.shadow=new xf}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},Ga=class extends Ro{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var vo=-90,yo=1,Io=class extends pn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ei(vo,yo,e,t);s.layers=this.layers,this.add(s);let r=new ei(vo,yo,e,t);r.layers=this.layers,this.add(r);let o=new ei(vo,yo,e,t);o.layers=this.layers,this.add(o);let a=new ei(vo,yo,e,t);a.layers=this.layers,this.add(a);let l=new ei(vo,yo,e,t);l.layers=this.layers,this.add(l);let c=new ei(vo,yo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ti)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===bo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let d=!1;e.isWebGLRenderer===!0?d=e.state.buffers.depth.getReversed():d=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),d&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,p),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Yc=class extends ei{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var $f="\\[\\]\\.:\\/",yM=new RegExp("["+$f+"]","g"),Zf="[^"+$f+"]",SM="[^"+$f.replace("\\.","")+"]",MM=/((?:WC+[\/:])*)/.source.replace("WC",Zf),bM=/(WCOD+)?/.source.replace("WCOD",SM),wM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Zf),EM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Zf),AM=new RegExp("^"+MM+bM+wM+EM+"$"),TM=["material","materials","bones","map"],vf=class{constructor(e,t,i){let s=i||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Zt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(yM,"")}static parseTrackName(e){let t=AM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);TM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){et("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){et("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){et("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){et("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){et("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){et("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;et("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){et("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=vf;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var DP=new Float32Array(1);var km=new vt,Er=class{constructor(e,t,i=0,s=1/0){this.ray=new Co(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new Ao,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):et("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return km.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(km),this}intersectObject(e,t=!0,i=[]){return yf(e,this,i,t),i.sort(zm),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)yf(e[s],this,i,t);return i.sort(zm),i}};function zm(n,e){return n.distance-e.distance}function yf(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)yf(r[o],e,t,!0)}}var Sf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Va=class extends Hi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Jf(n,e,t,i){let s=CM(i);switch(t){case kf:return n*e;case Fo:return n*e/s.components*s.byteLength;case tu:return n*e/s.components*s.byteLength;case Zi:return n*e*2/s.components*s.byteLength;case nu:return n*e*2/s.components*s.byteLength;case zf:return n*e*3/s.components*s.byteLength;case li:return n*e*4/s.components*s.byteLength;case iu:return n*e*4/s.components*s.byteLength;case Xa:case qa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ya:case $a:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ru:case au:return Math.max(n,16)*Math.max(e,8)/4;case su:case ou:return Math.max(n,8)*Math.max(e,8)/2;case lu:case cu:case hu:case fu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case uu:case Za:case du:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case pu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case mu:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case gu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case _u:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case xu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case vu:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case yu:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Su:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Mu:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case bu:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case wu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Eu:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Au:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Tu:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Cu:case Ru:case Pu:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Iu:case Lu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Ja:case Nu:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function CM(n){switch(n){case Wn:case Uf:return{byteLength:1,components:1};case Uo:case Ff:case $i:return{byteLength:2,components:1};case Qc:case eu:return{byteLength:2,components:4};case Yi:case Kc:case Pi:return{byteLength:4,components:1};case Of:case Bf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Jg(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function PM(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((p,g)=>p.start-g.start);let h=0;for(let p=1;p<f.length;p++){let g=f[h],y=f[p];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++h,f[h]=y)}f.length=h+1;for(let p=0,g=f.length;p<g;p++){let y=f[p];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var IM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,LM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,NM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,DM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,UM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,FM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,OM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,BM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,kM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,zM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,GM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,VM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,HM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,WM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,XM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,qM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,YM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,$M=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ZM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,JM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,jM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,KM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,QM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,eb=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,tb=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,nb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ib=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,sb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,rb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ob="gl_FragColor = linearToOutputTexel( gl_FragColor );",ab=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,lb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,cb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ub=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,hb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,fb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,db=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,pb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,mb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,gb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,_b=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,xb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,vb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,yb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Sb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Mb=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,bb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,wb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Eb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Ab=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Tb=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Cb=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Rb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Pb=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Ib=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Lb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Nb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Db=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ub=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Fb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ob=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Bb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,kb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,zb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Gb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Vb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Hb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Wb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Xb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Yb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$b=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Zb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Jb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,jb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Kb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Qb=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,ew=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,tw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,nw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,iw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,sw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,rw=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,ow=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,aw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,lw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,cw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,uw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,hw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,fw=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,dw=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,pw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,mw=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,gw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,_w=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,xw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,vw=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,yw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Sw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Mw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,bw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,ww=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Ew=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Aw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Tw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Cw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Rw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Pw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Iw=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Lw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Nw=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Dw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Uw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Fw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Ow=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Bw=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,kw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,zw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Gw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Vw=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Hw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ww=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Xw=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Yw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$w=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Zw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Jw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,jw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Kw=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Qw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,e1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,t1=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,n1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,i1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,s1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,r1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,o1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,a1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,l1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,c1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ft={alphahash_fragment:IM,alphahash_pars_fragment:LM,alphamap_fragment:NM,alphamap_pars_fragment:DM,alphatest_fragment:UM,alphatest_pars_fragment:FM,aomap_fragment:OM,aomap_pars_fragment:BM,batching_pars_vertex:kM,batching_vertex:zM,begin_vertex:GM,beginnormal_vertex:VM,bsdfs:HM,iridescence_fragment:WM,bumpmap_pars_fragment:XM,clipping_planes_fragment:qM,clipping_planes_pars_fragment:YM,clipping_planes_pars_vertex:$M,clipping_planes_vertex:ZM,color_fragment:JM,color_pars_fragment:jM,color_pars_vertex:KM,color_vertex:QM,common:eb,defaultnormal_vertex:tb,displacementmap_pars_vertex:nb,displacementmap_vertex:ib,emissivemap_fragment:sb,emissivemap_pars_fragment:rb,colorspace_fragment:ob,colorspace_pars_fragment:ab,envmap_fragment:lb,envmap_common_pars_fragment:cb,envmap_pars_fragment:ub,envmap_pars_vertex:hb,envmap_physical_pars_fragment:Mb,envmap_vertex:fb,fog_vertex:db,fog_pars_vertex:pb,fog_fragment:mb,fog_pars_fragment:gb,gradientmap_pars_fragment:_b,lightmap_pars_fragment:xb,lights_lambert_fragment:vb,lights_lambert_pars_fragment:yb,lights_pars_begin:Sb,lights_toon_fragment:bb,lights_toon_pars_fragment:wb,lights_phong_fragment:Eb,lights_phong_pars_fragment:Ab,lights_physical_fragment:Tb,lights_physical_pars_fragment:Cb,lights_fragment_begin:Rb,lights_fragment_maps:Pb,lights_fragment_end:Ib,lightprobes_pars_fragment:Lb,logdepthbuf_fragment:Nb,logdepthbuf_pars_fragment:Db,logdepthbuf_pars_vertex:Ub,logdepthbuf_vertex:Fb,map_fragment:Ob,map_pars_fragment:Bb,map_particle_fragment:kb,map_particle_pars_fragment:zb,metalnessmap_fragment:Gb,metalnessmap_pars_fragment:Vb,morphinstance_vertex:Hb,morphcolor_vertex:Wb,morphnormal_vertex:Xb,morphtarget_pars_vertex:qb,morphtarget_vertex:Yb,normal_fragment_begin:$b,normal_fragment_maps:Zb,normal_pars_fragment:Jb,normal_pars_vertex:jb,normal_vertex:Kb,normalmap_pars_fragment:Qb,clearcoat_normal_fragment_begin:ew,clearcoat_normal_fragment_maps:tw,clearcoat_pars_fragment:nw,iridescence_pars_fragment:iw,opaque_fragment:sw,packing:rw,premultiplied_alpha_fragment:ow,project_vertex:aw,dithering_fragment:lw,dithering_pars_fragment:cw,roughnessmap_fragment:uw,roughnessmap_pars_fragment:hw,shadowmap_pars_fragment:fw,shadowmap_pars_vertex:dw,shadowmap_vertex:pw,shadowmask_pars_fragment:mw,skinbase_vertex:gw,skinning_pars_vertex:_w,skinning_vertex:xw,skinnormal_vertex:vw,specularmap_fragment:yw,specularmap_pars_fragment:Sw,tonemapping_fragment:Mw,tonemapping_pars_fragment:bw,transmission_fragment:ww,transmission_pars_fragment:Ew,uv_pars_fragment:Aw,uv_pars_vertex:Tw,uv_vertex:Cw,worldpos_vertex:Rw,background_vert:Pw,background_frag:Iw,backgroundCube_vert:Lw,backgroundCube_frag:Nw,cube_vert:Dw,cube_frag:Uw,depth_vert:Fw,depth_frag:Ow,distance_vert:Bw,distance_frag:kw,equirect_vert:zw,equirect_frag:Gw,linedashed_vert:Vw,linedashed_frag:Hw,meshbasic_vert:Ww,meshbasic_frag:Xw,meshlambert_vert:qw,meshlambert_frag:Yw,meshmatcap_vert:$w,meshmatcap_frag:Zw,meshnormal_vert:Jw,meshnormal_frag:jw,meshphong_vert:Kw,meshphong_frag:Qw,meshphysical_vert:e1,meshphysical_frag:t1,meshtoon_vert:n1,meshtoon_frag:i1,points_vert:s1,points_frag:r1,shadow_vert:o1,shadow_frag:a1,sprite_vert:l1,sprite_frag:c1},De={common:{diffuse:{value:new Ye(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new ct(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ye(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ye(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new Ye(16777215)},opacity:{value:1},center:{value:new ct(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},ps={basic:{uniforms:Xn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Xn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new Ye(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Xn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new Ye(0)},specular:{value:new Ye(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Xn([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new Ye(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Xn([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new Ye(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Xn([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Xn([De.points,De.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Xn([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Xn([De.common,De.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Xn([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Xn([De.sprite,De.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:Xn([De.common,De.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:Xn([De.lights,De.fog,{color:{value:new Ye(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};ps.physical={uniforms:Xn([ps.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new ct(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new Ye(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new ct},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new Ye(0)},specularColor:{value:new Ye(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new ct},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Du={r:0,b:0,g:0},u1=new vt,jg=new nt;jg.set(-1,0,0,0,1,0,0,0,1);function h1(n,e,t,i,s,r){let o=new Ye(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function p(v){let T=v.isScene===!0?v.background:null;if(T&&T.isTexture){let S=v.backgroundBlurriness>0;T=e.get(T,S)}return T}function g(v){let T=!1,S=p(v);S===null?d(o,a):S&&S.isColor&&(d(S,1),T=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(v,T){let S=p(T);S&&S.isCubeTexture?(c===void 0&&(c=new be(new cn(1,1,1),new ai({name:"BackgroundCubeMaterial",uniforms:Ir(ps.backgroundCube.uniforms),vertexShader:ps.backgroundCube.vertexShader,fragmentShader:ps.backgroundCube.fragmentShader,side:ni,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(u1.makeRotationFromEuler(T.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(jg),c.material.toneMapped=xt.getTransfer(S.colorSpace)!==Ct,(u!==S||f!==S.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new be(new Ls(2,2),new ai({name:"BackgroundMaterial",uniforms:Ir(ps.background.uniforms),vertexShader:ps.background.vertexShader,fragmentShader:ps.background.fragmentShader,side:or,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=xt.getTransfer(S.colorSpace)!==Ct,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||f!==S.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function d(v,T){v.getRGB(Du,Yf(n)),t.buffers.color.setClear(Du.r,Du.g,Du.b,T,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,T=1){o.set(v),a=T,d(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,d(o,a)},render:g,addToRenderList:y,dispose:m}}function f1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(I,k,W,N,V){let Y=!1,G=f(I,N,W,k);r!==G&&(r=G,c(r.object)),Y=p(I,N,W,V),Y&&g(I,N,W,V),V!==null&&e.update(V,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(I,k,W,N),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function f(I,k,W,N){let V=N.wireframe===!0,Y=i[k.id];Y===void 0&&(Y={},i[k.id]=Y);let G=I.isInstancedMesh===!0?I.id:0,ae=Y[G];ae===void 0&&(ae={},Y[G]=ae);let q=ae[W.id];q===void 0&&(q={},ae[W.id]=q);let K=q[V];return K===void 0&&(K=h(l()),q[V]=K),K}function h(I){let k=[],W=[],N=[];for(let V=0;V<t;V++)k[V]=0,W[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:W,attributeDivisors:N,object:I,attributes:{},index:null}}function p(I,k,W,N){let V=r.attributes,Y=k.attributes,G=0,ae=W.getAttributes();for(let q in ae)if(ae[q].location>=0){let ne=V[q],he=Y[q];if(he===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(he=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(he=I.instanceColor)),ne===void 0||ne.attribute!==he||he&&ne.data!==he.data)return!0;G++}return r.attributesNum!==G||r.index!==N}function g(I,k,W,N){let V={},Y=k.attributes,G=0,ae=W.getAttributes();for(let q in ae)if(ae[q].location>=0){let ne=Y[q];ne===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(ne=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(ne=I.instanceColor));let he={};he.attribute=ne,ne&&ne.data&&(he.data=ne.data),V[q]=he,G++}r.attributes=V,r.attributesNum=G,r.index=N}function y(){let I=r.newAttributes;for(let k=0,W=I.length;k<W;k++)I[k]=0}function d(I){m(I,0)}function m(I,k){let W=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;W[I]=1,N[I]===0&&(n.enableVertexAttribArray(I),N[I]=1),V[I]!==k&&(n.vertexAttribDivisor(I,k),V[I]=k)}function v(){let I=r.newAttributes,k=r.enabledAttributes;for(let W=0,N=k.length;W<N;W++)k[W]!==I[W]&&(n.disableVertexAttribArray(W),k[W]=0)}function T(I,k,W,N,V,Y,G){G===!0?n.vertexAttribIPointer(I,k,W,V,Y):n.vertexAttribPointer(I,k,W,N,V,Y)}function S(I,k,W,N){y();let V=N.attributes,Y=W.getAttributes(),G=k.defaultAttributeValues;for(let ae in Y){let q=Y[ae];if(q.location>=0){let K=V[ae];if(K===void 0&&(ae==="instanceMatrix"&&I.instanceMatrix&&(K=I.instanceMatrix),ae==="instanceColor"&&I.instanceColor&&(K=I.instanceColor)),K!==void 0){let ne=K.normalized,he=K.itemSize,fe=e.get(K);if(fe===void 0)continue;let Q=fe.buffer,ge=fe.type,ve=fe.bytesPerElement,Re=ge===n.INT||ge===n.UNSIGNED_INT||K.gpuType===Kc;if(K.isInterleavedBufferAttribute){let we=K.data,Xe=we.isInterleavedBuffer===!0?we.stride:we.itemSize,ot=K.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let He=0;He<q.locationSize;He++)m(q.location+He,we.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let He=0;He<q.locationSize;He++)d(q.location+He);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let He=0;He<q.locationSize;He++)T(q.location+He,he/q.locationSize,ge,ne,Xe*ve,(ot+he/q.locationSize*He)*ve,Re)}else{if(K.isInstancedBufferAttribute){for(let we=0;we<q.locationSize;we++)m(q.location+we,K.meshPerAttribute);I.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let we=0;we<q.locationSize;we++)d(q.location+we);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let we=0;we<q.locationSize;we++)T(q.location+we,he/q.locationSize,ge,ne,he*ve,he/q.locationSize*we*ve,Re)}}else if(G!==void 0){let ne=G[ae];if(ne!==void 0)switch(ne.length){case 2:n.vertexAttrib2fv(q.location,ne);break;case 3:n.vertexAttrib3fv(q.location,ne);break;case 4:n.vertexAttrib4fv(q.location,ne);break;default:n.vertexAttrib1fv(q.location,ne)}}}}v()}function C(){U();for(let I in i){let k=i[I];for(let W in k){let N=k[W];for(let V in N){let Y=N[V];for(let G in Y)u(Y[G].object),delete Y[G];delete N[V]}}delete i[I]}}function A(I){if(i[I.id]===void 0)return;let k=i[I.id];for(let W in k){let N=k[W];for(let V in N){let Y=N[V];for(let G in Y)u(Y[G].object),delete Y[G];delete N[V]}}delete i[I.id]}function _(I){for(let k in i){let W=i[k];for(let N in W){let V=W[N];if(V[I.id]===void 0)continue;let Y=V[I.id];for(let G in Y)u(Y[G].object),delete Y[G];delete V[I.id]}}}function w(I){for(let k in i){let W=i[k],N=I.isInstancedMesh===!0?I.id:0,V=W[N];if(V!==void 0){for(let Y in V){let G=V[Y];for(let ae in G)u(G[ae].object),delete G[ae];delete V[Y]}delete W[N],Object.keys(W).length===0&&delete i[k]}}}function U(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:w,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:d,disableUnusedAttributes:v}}function d1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let p=0;p<u;p++)h+=c[p];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function p1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==li&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let w=_===$i&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==Wn&&_!==Pi&&!w&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),d=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:d,maxAttributes:m,maxVertexUniforms:v,maxVaryings:T,maxFragmentUniforms:S,maxSamples:C,samples:A}}function m1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Vi,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let p=f.length!==0||h||i!==0||s;return s=h,i=f.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,p){let g=f.clippingPlanes,y=f.clipIntersection,d=f.clipShadows,m=n.get(f);if(!s||g===null||g.length===0||r&&!d)r?u(null):c();else{let v=r?0:i,T=v*4,S=m.clippingState||null;l.value=S,S=u(g,h,T,p);for(let C=0;C!==T;++C)S[C]=t[C];m.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,p,g){let y=f!==null?f.length:0,d=null;if(y!==0){if(d=l.value,g!==!0||d===null){let m=p+y*4,v=h.matrixWorldInverse;a.getNormalMatrix(v),(d===null||d.length<m)&&(d=new Float32Array(m));for(let T=0,S=p;T!==y;++T,S+=4)o.copy(f[T]).applyMatrix4(v,a),o.normal.toArray(d,S),d[S+3]=o.constant}l.value=d,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,d}}var tl=class extends _i{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ia(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new cn(5,5,5),r=new ai({name:"CubemapFromEquirect",uniforms:Ir(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ni,blending:Tr});r.uniforms.tEquirect.value=t;let o=new be(s,r),a=t.minFilter;return t.minFilter===Ns&&(t.minFilter=ti),new Io(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},Rg=256,g1=3,_1=20,Kg=256,Qg=16,x1=3,v1=new B,y1=new Ye,Fu=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Io(1,10,null),this._boxMesh=new be(new cn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=v1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(y1));let d=new Io(i,s,u);return d.position.copy(a),d.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=p,l.autoClearStencil=g,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Lg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Ig(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Rg,wg(e))}_fromTexture(e,t){e.mapping===Rr||e.mapping===Do?this._setSize(e.image.length===0?Rg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Pg(e,!1,!1),i=Math.log2(e)-g1;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Pg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Rr||e.mapping===Do?(this._cubemapMaterial===null&&(this._cubemapMaterial=Lg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Ig()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=S1(),this._integrationMaterial=M1());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Qg);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-x1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Kg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=b1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Pg(n,e,t){return new tl(n,{minFilter:Ns,generateMipmaps:e,type:$i,colorSpace:Sa,depthBuffer:t})}function nl(n,e,t){return new ai({name:n,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:ni,blending:Tr,depthTest:!1,depthWrite:!1})}function S1(){return nl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Kg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function M1(){return nl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Qg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function b1(){return nl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${_1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Ig(){return nl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Lg(){return nl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function w1(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,p=!1){return h==null?null:p?o(h):r(h)}function r(h){if(h&&h.isTexture){let p=h.mapping;if(p===Zc||p===Jc)if(e.has(h)){let g=e.get(h).texture;return a(g,h.mapping)}else{let g=h.image;if(g&&g.height>0){let y=new tl(g.height);return y.fromEquirectangularTexture(n,h),e.set(h,y),h.addEventListener("dispose",c),a(y.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let p=h.mapping,g=p===Zc||p===Jc,y=p===Rr||p===Do;if(g||y){let d=t.get(h),m=d!==void 0?d.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new Fu(n)),d=g?i.fromEquirectangular(h,d):i.fromCubemap(h,d),d.texture.pmremVersion=h.pmremVersion,t.set(h,d),d.texture;if(d!==void 0)return d.texture;{let v=h.image;return g&&v&&v.height>0||y&&v&&l(v)?(i===null&&(i=new Fu(n)),d=g?i.fromEquirectangular(h):i.fromCubemap(h),d.texture.pmremVersion=h.pmremVersion,t.set(h,d),h.addEventListener("dispose",u),d.texture):null}}}return h}function a(h,p){return p===Zc?h.mapping=Rr:p===Jc&&(h.mapping=Do),h}function l(h){let p=0,g=6;for(let y=0;y<g;y++)h[y]!==void 0&&p++;return p===g}function c(h){let p=h.target;p.removeEventListener("dispose",c);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function u(h){let p=h.target;p.removeEventListener("dispose",u);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function E1(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&va("WebGLRenderer: "+i+" extension not supported."),s}}}function A1(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let d in g.attributes)e.remove(g.attributes[d]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(g){let y=g.attributes;for(let d in y)e.update(y[d],n.ARRAY_BUFFER)}function f(g){let y=g.index,d=g.attributes.position,m=0;if(d===void 0)return;let v=y!==null?y.array.length:d.array.length/3-1,T=d.count>=65535?Ta:Aa,S=new T(Math.ceil(v/3)*6,1),C=S.array;if(y!==null){let _=y.array;m=y.version;for(let w=0,U=0;w<v;w+=3){let L=_[w+0],I=_[w+1],k=_[w+2];C[U++]=L,C[U++]=I,C[U++]=I,C[U++]=k,C[U++]=k,C[U++]=L}}else{m=d.version;for(let _=0,w=0;_<v;_+=3){let U=_+0,L=_+1,I=_+2;C[w++]=U,C[w++]=L,C[w++]=L,C[w++]=I,C[w++]=I,C[w++]=U}}S.version=m;let A=r.get(g);A&&e.remove(A),r.set(g,S)}function h(g){let y=r.get(g);if(y){let d=g.index;d!==null&&y.version<d.version&&f(g)}else f(g);return r.get(g)}function p(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:h,dispose:p}}function T1(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,p){p!==0&&(n.drawElementsInstanced(i,h,r,f*o,p),t.update(h,i,p))}function u(f,h,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,p);let y=0;for(let d=0;d<p;d++)y+=h[d];t.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function C1(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:et("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function R1(n,e,t){let i=new WeakMap,s=new Ht;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let U=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",U)};h!==void 0&&h.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,d=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],T=0;p===!0&&(T=1),g===!0&&(T=2),y===!0&&(T=3);let S=a.attributes.position.count*T,C=1;S>e.maxTextureSize&&(C=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let A=new Float32Array(S*C*4*f),_=new wa(A,S,C,f);_.type=Pi,_.needsUpdate=!0;let w=T*4;for(let L=0;L<f;L++){let I=d[L],k=m[L],W=v[L],N=S*C*4*L;for(let V=0;V<I.count;V++){let Y=V*w;p===!0&&(s.fromBufferAttribute(I,V),A[N+Y+0]=s.x,A[N+Y+1]=s.y,A[N+Y+2]=s.z,A[N+Y+3]=0),g===!0&&(s.fromBufferAttribute(k,V),A[N+Y+4]=s.x,A[N+Y+5]=s.y,A[N+Y+6]=s.z,A[N+Y+7]=0),y===!0&&(s.fromBufferAttribute(W,V),A[N+Y+8]=s.x,A[N+Y+9]=s.y,A[N+Y+10]=s.z,A[N+Y+11]=W.itemSize===4?s.w:1)}}h={count:f,texture:_,size:new ct(S,C)},i.set(a,h),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let y=0;y<c.length;y++)p+=c[y];let g=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function P1(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var I1={[Cf]:"LINEAR_TONE_MAPPING",[Rf]:"REINHARD_TONE_MAPPING",[Pf]:"CINEON_TONE_MAPPING",[If]:"ACES_FILMIC_TONE_MAPPING",[Nf]:"AGX_TONE_MAPPING",[Ha]:"NEUTRAL_TONE_MAPPING",[Lf]:"CUSTOM_TONE_MAPPING"};function L1(n,e,t,i,s,r){let o=new _i(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new mn;u.setAttribute("position",new Dt([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Dt([0,2,0,0,2,0],2));let f=new Nc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new be(u,f),p=new za(-1,1,1,-1,0,1),g=null,y=null,d=!1,m,v=null,T=[],S=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let _=0;_<T.length;_++){let w=T[_];w.setSize&&w.setSize(C,A)}},this.setEffects=function(C){T=C,S=T.length>0&&T[0].isRenderPass===!0;let A=o.width,_=o.height;T.length>0&&a===null&&(a=new _i(A,_,{type:$i,depthBuffer:!1,stencilBuffer:!1}),l=new _i(A,_,{type:$i,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&T.some(U=>U.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Ps(A,_),r===!0&&(c.format=Ds,c.type=Pr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let U=0;U<T.length;U++){let L=T[U];L.setSize&&L.setSize(A,_),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(C,A){if(d||C.toneMapping===fs&&T.length===0)return!1;if(v=A,A!==null){let _=A.width,w=A.height;(o.width!==_||o.height!==w)&&this.setSize(_,w)}return S===!1&&C.setRenderTarget(o),m=C.toneMapping,C.toneMapping=fs,!0},this.hasRenderPass=function(){return S},this.end=function(C,A){C.toneMapping=m,d=!0;let _=o,w=a;for(let U=0;U<T.length;U++){let L=T[U];L.enabled!==!1&&(L.render(C,w,_,A),L.needsSwap!==!1&&(_=w,w=w===a?l:a))}if(g!==C.outputColorSpace||y!==C.toneMapping){g=C.outputColorSpace,y=C.toneMapping,f.defines={},xt.getTransfer(g)===Ct&&(f.defines.SRGB_TRANSFER="");let U=I1[y];U&&(f.defines[U]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(v),C.render(h,p),v=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var e0=new oi,t0=new Ps(1,1),n0=new La(1),i0=new wa,s0=new Cc,r0=new Ia,Ng=[],Dg=[],Ug=new Float32Array(16),Fg=new Float32Array(9),Og=new Float32Array(4);function Bo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Ng[s];if(r===void 0&&(r=new Float32Array(s),Ng[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Tn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Cn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Bu(n,e){let t=Dg[e];t===void 0&&(t=new Int32Array(e),Dg[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function N1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function D1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2fv(this.addr,e),Cn(t,e)}}function U1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Tn(t,e))return;n.uniform3fv(this.addr,e),Cn(t,e)}}function F1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4fv(this.addr,e),Cn(t,e)}}function O1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Cn(t,e)}else{if(Tn(t,i))return;Og.set(i),n.uniformMatrix2fv(this.addr,!1,Og),Cn(t,i)}}function B1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Cn(t,e)}else{if(Tn(t,i))return;Fg.set(i),n.uniformMatrix3fv(this.addr,!1,Fg),Cn(t,i)}}function k1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Cn(t,e)}else{if(Tn(t,i))return;Ug.set(i),n.uniformMatrix4fv(this.addr,!1,Ug),Cn(t,i)}}function z1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function G1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2iv(this.addr,e),Cn(t,e)}}function V1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Tn(t,e))return;n.uniform3iv(this.addr,e),Cn(t,e)}}function H1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4iv(this.addr,e),Cn(t,e)}}function W1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function X1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2uiv(this.addr,e),Cn(t,e)}}function q1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Tn(t,e))return;n.uniform3uiv(this.addr,e),Cn(t,e)}}function Y1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4uiv(this.addr,e),Cn(t,e)}}function ku(n){return n.version===0&&(n.compareFunction=Hf,n.needsUpdate=!0),n}function $1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=ku(t0):r=e0,t.setTexture2D(e||r,s)}function Z1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||s0,s)}function J1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=ku(n0):r=r0,t.setTextureCube(e||r,s)}function j1(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||i0,s)}function K1(n){switch(n){case 5126:return N1;case 35664:return D1;case 35665:return U1;case 35666:return F1;case 35674:return O1;case 35675:return B1;case 35676:return k1;case 5124:case 35670:return z1;case 35667:case 35671:return G1;case 35668:case 35672:return V1;case 35669:case 35673:return H1;case 5125:return W1;case 36294:return X1;case 36295:return q1;case 36296:return Y1;case 35678:case 36198:case 36298:case 36306:case 35682:return $1;case 35679:case 36299:case 36307:return Z1;case 35680:case 36300:case 36308:case 36293:return J1;case 36289:case 36303:case 36311:case 36292:return j1}}function Q1(n,e){n.uniform1fv(this.addr,e)}function eE(n,e){let t=Bo(e,this.size,2);n.uniform2fv(this.addr,t)}function tE(n,e){let t=Bo(e,this.size,3);n.uniform3fv(this.addr,t)}function nE(n,e){let t=Bo(e,this.size,4);n.uniform4fv(this.addr,t)}function iE(n,e){let t=Bo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function sE(n,e){let t=Bo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function rE(n,e){let t=Bo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function oE(n,e){n.uniform1iv(this.addr,e)}function aE(n,e){n.uniform2iv(this.addr,e)}function lE(n,e){n.uniform3iv(this.addr,e)}function cE(n,e){n.uniform4iv(this.addr,e)}function uE(n,e){n.uniform1uiv(this.addr,e)}function hE(n,e){n.uniform2uiv(this.addr,e)}function fE(n,e){n.uniform3uiv(this.addr,e)}function dE(n,e){n.uniform4uiv(this.addr,e)}function pE(n,e,t){let i=this.cache,s=e.length,r=Bu(t,s);Tn(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=ku(t0):o=e0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function mE(n,e,t){let i=this.cache,s=e.length,r=Bu(t,s);Tn(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||s0,r[o])}function gE(n,e,t){let i=this.cache,s=e.length,r=Bu(t,s);Tn(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=ku(n0):o=r0;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function _E(n,e,t){let i=this.cache,s=e.length,r=Bu(t,s);Tn(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||i0,r[o])}function xE(n){switch(n){case 5126:return Q1;case 35664:return eE;case 35665:return tE;case 35666:return nE;case 35674:return iE;case 35675:return sE;case 35676:return rE;case 5124:case 35670:return oE;case 35667:case 35671:return aE;case 35668:case 35672:return lE;case 35669:case 35673:return cE;case 5125:return uE;case 36294:return hE;case 36295:return fE;case 36296:return dE;case 35678:case 36198:case 36298:case 36306:case 35682:return pE;case 35679:case 36299:case 36307:return mE;case 35680:case 36300:case 36308:case 36293:return gE;case 36289:case 36303:case 36311:case 36292:return _E}}var Qf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=K1(t.type)}},ed=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=xE(t.type)}},td=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},jf=/(\w+)(\])?(\[|\.)?/g;function Bg(n,e){n.seq.push(e),n.map[e.id]=e}function vE(n,e,t){let i=n.name,s=i.length;for(jf.lastIndex=0;;){let r=jf.exec(i),o=jf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Bg(t,c===void 0?new Qf(a,n,e):new ed(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new td(a),Bg(t,f)),t=f}}}var Oo=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);vE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function kg(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var yE=37297,SE=0;function ME(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var zg=new nt;function bE(n){xt._getMatrix(zg,xt.workingColorSpace,n);let e=`mat3( ${zg.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(n)){case Ma:return[e,"LinearTransferOETF"];case Ct:return[e,"sRGBTransferOETF"];default:return Je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Gg(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+ME(n.getShaderSource(e),a)}else return r}function wE(n,e){let t=bE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var EE={[Cf]:"Linear",[Rf]:"Reinhard",[Pf]:"Cineon",[If]:"ACESFilmic",[Nf]:"AgX",[Ha]:"Neutral",[Lf]:"Custom"};function AE(n,e){let t=EE[e];return t===void 0?(Je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Uu=new B;function TE(){xt.getLuminanceCoefficients(Uu);let n=Uu.x.toFixed(4),e=Uu.y.toFixed(4),t=Uu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function CE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(el).join(`
`)}function RE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function PE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function el(n){return n!==""}function Vg(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Hg(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var IE=/^[ \t]*#include +<([\w\d./]+)>/gm;function nd(n){return n.replace(IE,LE)}function LE(n,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return nd(t)}var NE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Wg(n){return n.replace(NE,DE)}function DE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Xg(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var UE={[Ar]:"SHADOWMAP_TYPE_PCF",[Lo]:"SHADOWMAP_TYPE_VSM"};function FE(n){return UE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var OE={[Do]:"ENVMAP_MODE_REFRACTION"};function BE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":OE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var kE={[$c]:"ENVMAP_BLENDING_MULTIPLY",[lg]:"ENVMAP_BLENDING_MIX",[cg]:"ENVMAP_BLENDING_ADD"};function zE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":kE[n.combine]||"ENVMAP_BLENDING_NONE"}function GE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=FE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=BE(t),f=zE(t),h=CE(t),p=RE(r),g=s.createProgram(),y,d,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(el).join(`
`),y.length>0&&(y+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(el).join(`
`),d.length>0&&(d+=`
`)):(y=[Xg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(el).join(`
`),d=[Xg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==fs?"#define TONE_MAPPING":"",t.toneMapping!==fs?ft.tonemapping_pars_fragment:"",t.toneMapping!==fs?AE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,wE("linearToOutputTexel",t.outputColorSpace),TE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(el).join(`
`)),o=nd(o),o=Vg(o,t),o=Hg(o,t),a=nd(a),a=Vg(a,t),a=Hg(a,t),o=Wg(o),a=Wg(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,d=["#define varying in",t.glslVersion===Wf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Wf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let v=m+y+o,T=m+d+a,S=kg(s,s.VERTEX_SHADER,v),C=kg(s,s.FRAGMENT_SHADER,T);s.attachShader(g,S),s.attachShader(g,C),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(L){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(g)||"",k=s.getShaderInfoLog(S)||"",W=s.getShaderInfoLog(C)||"",N=I.trim(),V=k.trim(),Y=W.trim(),G=!0,ae=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,S,C);else{let q=Gg(s,S,"vertex"),K=Gg(s,C,"fragment");et("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+N+`
`+q+`
`+K)}else N!==""?Je("WebGLProgram: Program Info Log:",N):(V===""||Y==="")&&(ae=!1);ae&&(L.diagnostics={runnable:G,programLog:N,vertexShader:{log:V,prefix:y},fragmentShader:{log:Y,prefix:d}})}s.deleteShader(S),s.deleteShader(C),_=new Oo(s,g),w=PE(s,g)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let w;this.getAttributes=function(){return w===void 0&&A(this),w};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(g,yE)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=SE++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=C,this}var VE=0,id=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new sd(e),t.set(e,i)),i}},sd=class{constructor(e){this.id=VE++,this.code=e,this.usedTimes=0}};function HE(n){return n===Zi||n===Za||n===Ja}function WE(n,e,t,i,s,r){let o=new Ao,a=new id,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,w,U,L,I,k){let W=L.fog,N=I.geometry,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?L.environment:null,Y=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,G=e.get(_.envMap||V,Y),ae=h[_.type],q=i.precision;_.precision!==null&&(q=i.getMaxPrecision(_.precision),q!==_.precision&&Je("WebGLProgram.getParameters:",_.precision,"not supported, using",q,"instead."));let K=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ne=K!==void 0?K.length:0,he=0;N.morphAttributes.position!==void 0&&(he=1),N.morphAttributes.normal!==void 0&&(he=2),N.morphAttributes.color!==void 0&&(he=3);let fe,Q,ge,ve;if(ae){let Pe=ps[ae];fe=Pe.vertexShader,Q=Pe.fragmentShader}else{fe=_.vertexShader,Q=_.fragmentShader;let Pe=a.getVertexShaderStage(_),lt=a.getFragmentShaderStage(_);a.update(_,Pe,lt),ge=Pe.id,ve=lt.id}let Re=n.getRenderTarget(),we=n.state.buffers.depth.getReversed(),Xe=I.isInstancedMesh===!0,ot=I.isBatchedMesh===!0,He=!!_.map,dt=!!_.matcap,ut=!!G,st=ut&&G.isPMREMTexture===!0,jt=!!_.aoMap,Vt=!!_.lightMap,gn=!!_.bumpMap&&_.wireframe===!1,Ut=!!_.normalMap,In=!!_.displacementMap,Mt=!!_.emissiveMap,En=!!_.metalnessMap,nn=!!_.roughnessMap,_n=_.anisotropy>0,O=_.clearcoat>0,Ie=_.diffuseRoughness>0,Ze=_.dispersion>0,at=_.retroreflectivity>0,Ee=_.iridescence>0,Ot=_.sheen>0,Ve=_.transmission>0,$e=_n&&!!_.anisotropyMap,R=O&&!!_.clearcoatMap,M=O&&!!_.clearcoatNormalMap,X=O&&!!_.clearcoatRoughnessMap,ue=Ie&&!!_.diffuseRoughnessMap,re=Ee&&!!_.iridescenceMap,xe=Ee&&!!_.iridescenceThicknessMap,ye=Ot&&!!_.sheenColorMap,ee=Ot&&!!_.sheenRoughnessMap,ie=!!_.specularMap,me=!!_.specularColorMap,F=!!_.specularIntensityMap,se=Ve&&!!_.transmissionMap,te=Ve&&!!_.thicknessMap,Ae=!!_.gradientMap,_e=!!_.alphaMap,Me=_.alphaTest>0,We=!!_.alphaHash,Ke=!!_.extensions,ce=fs;_.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ke=st?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Qe={shaderID:ae,shaderType:_.type,shaderName:_.name,vertexShader:fe,fragmentShader:Q,defines:_.defines,customVertexShaderID:ge,customFragmentShaderID:ve,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:q,batching:ot,batchingColor:ot&&I._colorsTexture!==null,instancing:Xe,instancingColor:Xe&&I.instanceColor!==null,instancingMorph:Xe&&I.morphTexture!==null,outputColorSpace:Re===null?n.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:xt.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:He,matcap:dt,envMap:ut,envMapMode:ut&&G.mapping,envMapPMREM:st,envMapMaxLod:st?ke.length-1:null,envMapSize:st?ke[0].width:null,aoMap:jt,lightMap:Vt,bumpMap:gn,normalMap:Ut,displacementMap:In,emissiveMap:Mt,normalMapObjectSpace:Ut&&_.normalMapType===fg,normalMapTangentSpace:Ut&&_.normalMapType===ja,packedNormalMap:Ut&&_.normalMapType===ja&&HE(_.normalMap.format),metalnessMap:En,roughnessMap:nn,anisotropy:_n,anisotropyMap:$e,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:X,diffuseRoughness:Ie,diffuseRoughnessMap:ue,dispersion:Ze,retroreflection:at,iridescence:Ee,iridescenceMap:re,iridescenceThicknessMap:xe,sheen:Ot,sheenColorMap:ye,sheenRoughnessMap:ee,specularMap:ie,specularColorMap:me,specularIntensityMap:F,transmission:Ve,transmissionMap:se,thicknessMap:te,gradientMap:Ae,opaque:_.transparent===!1&&_.blending===No&&_.alphaToCoverage===!1,alphaMap:_e,alphaTest:Me,alphaHash:We,combine:_.combine,mapUv:He&&p(_.map.channel),aoMapUv:jt&&p(_.aoMap.channel),lightMapUv:Vt&&p(_.lightMap.channel),bumpMapUv:gn&&p(_.bumpMap.channel),normalMapUv:Ut&&p(_.normalMap.channel),displacementMapUv:In&&p(_.displacementMap.channel),emissiveMapUv:Mt&&p(_.emissiveMap.channel),metalnessMapUv:En&&p(_.metalnessMap.channel),roughnessMapUv:nn&&p(_.roughnessMap.channel),anisotropyMapUv:$e&&p(_.anisotropyMap.channel),clearcoatMapUv:R&&p(_.clearcoatMap.channel),clearcoatNormalMapUv:M&&p(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&p(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&p(_.diffuseRoughnessMap.channel),iridescenceMapUv:re&&p(_.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&p(_.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&p(_.sheenColorMap.channel),sheenRoughnessMapUv:ee&&p(_.sheenRoughnessMap.channel),specularMapUv:ie&&p(_.specularMap.channel),specularColorMapUv:me&&p(_.specularColorMap.channel),specularIntensityMapUv:F&&p(_.specularIntensityMap.channel),transmissionMapUv:se&&p(_.transmissionMap.channel),thicknessMapUv:te&&p(_.thicknessMap.channel),alphaMapUv:_e&&p(_.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Ut||_n),vertexNormals:!!N.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!N.attributes.uv&&(He||_e),fog:!!W,useFog:_.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||N.attributes.normal===void 0&&Ut===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:we,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:he,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:k.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:He&&_.map.isVideoTexture===!0&&xt.getTransfer(_.map.colorSpace)===Ct,decodeVideoTextureEmissive:Mt&&_.emissiveMap.isVideoTexture===!0&&xt.getTransfer(_.emissiveMap.colorSpace)===Ct,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ri,flipSided:_.side===ni,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Ke&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ke&&_.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function y(_){let w=[];if(_.shaderID?w.push(_.shaderID):(w.push(_.customVertexShaderID),w.push(_.customFragmentShaderID)),_.defines!==void 0)for(let U in _.defines)w.push(U),w.push(_.defines[U]);return _.isRawShaderMaterial===!1&&(d(w,_),m(w,_),w.push(n.outputColorSpace)),w.push(_.customProgramCacheKey),w.join()}function d(_,w){_.push(w.precision),_.push(w.outputColorSpace),_.push(w.envMapMode),_.push(w.envMapPMREM),_.push(w.envMapMaxLod),_.push(w.envMapSize),_.push(w.mapUv),_.push(w.alphaMapUv),_.push(w.lightMapUv),_.push(w.aoMapUv),_.push(w.bumpMapUv),_.push(w.normalMapUv),_.push(w.displacementMapUv),_.push(w.emissiveMapUv),_.push(w.metalnessMapUv),_.push(w.roughnessMapUv),_.push(w.anisotropyMapUv),_.push(w.clearcoatMapUv),_.push(w.clearcoatNormalMapUv),_.push(w.clearcoatRoughnessMapUv),_.push(w.diffuseRoughnessMapUv),_.push(w.iridescenceMapUv),_.push(w.iridescenceThicknessMapUv),_.push(w.sheenColorMapUv),_.push(w.sheenRoughnessMapUv),_.push(w.specularMapUv),_.push(w.specularColorMapUv),_.push(w.specularIntensityMapUv),_.push(w.transmissionMapUv),_.push(w.thicknessMapUv),_.push(w.combine),_.push(w.fogExp2),_.push(w.sizeAttenuation),_.push(w.morphTargetsCount),_.push(w.numSunLights),_.push(w.numDirLights),_.push(w.numPointLights),_.push(w.numSpotLights),_.push(w.numSpotLightMaps),_.push(w.numHemiLights),_.push(w.numRectAreaLights),_.push(w.numSunLightShadows),_.push(w.numDirLightShadows),_.push(w.numPointLightShadows),_.push(w.numSpotLightShadows),_.push(w.numSpotLightShadowsWithMaps),_.push(w.numLightProbes),_.push(w.numLightProbeGrids),_.push(w.shadowMapType),_.push(w.toneMapping),_.push(w.numClippingPlanes),_.push(w.numClipIntersection),_.push(w.depthPacking)}function m(_,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let w=h[_.type],U;if(w){let L=ps[w];U=Ag.clone(L.uniforms)}else U=_.uniforms;return U}function T(_,w){let U=u.get(w);return U!==void 0?++U.usedTimes:(U=new GE(n,w,_,s),c.push(U),u.set(w,U)),U}function S(_){if(--_.usedTimes===0){let w=c.indexOf(_);c[w]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function A(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:v,acquireProgram:T,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:A}}function XE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function qE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function qg(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Yg(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let p=0;return h.isInstancedMesh&&(p+=2),h.isSkinnedMesh&&(p+=1),p}function a(h,p,g,y,d,m){let v=n[e];return v===void 0?(v={id:h.id,object:h,geometry:p,material:g,materialVariant:o(h),groupOrder:y,renderOrder:h.renderOrder,z:d,group:m},n[e]=v):(v.id=h.id,v.object=h,v.geometry=p,v.material=g,v.materialVariant=o(h),v.groupOrder=y,v.renderOrder=h.renderOrder,v.z=d,v.group=m),e++,v}function l(h,p,g,y,d,m,v){v.reversedDepth===!0&&(d=-d);let T=a(h,p,g,y,d,m);g.transmission>0?i.push(T):g.transparent===!0?s.push(T):t.push(T)}function c(h,p,g,y,d,m){let v=a(h,p,g,y,d,m);g.transmission>0?i.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function u(h,p){t.length>1&&t.sort(h||qE),i.length>1&&i.sort(p||qg),s.length>1&&s.sort(p||qg)}function f(){for(let h=e,p=n.length;h<p;h++){let g=n[h];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function YE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Yg,n.set(i,[o])):s>=r.length?(o=new Yg,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function $E(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new B,color:new Ye};break;case"SpotLight":t={position:new B,direction:new B,color:new Ye,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new B,color:new Ye,distance:0,decay:0};break;case"HemisphereLight":t={direction:new B,skyColor:new Ye,groundColor:new Ye};break;case"RectAreaLight":t={color:new Ye,position:new B,halfWidth:new B,halfHeight:new B};break}return n[e.id]=t,t}}}function ZE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var JE=0;function jE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function KE(n){let e=new $E,t=ZE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new B);let s=new B,r=new vt,o=new vt;function a(c){let u=0,f=0,h=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let p=0,g=0,y=0,d=0,m=0,v=0,T=0,S=0,C=0,A=0,_=0,w=0,U=0,L=0;c.sort(jE);for(let k=0,W=c.length;k<W;k++){let N=c[k],V=N.color,Y=N.intensity,G=N.distance,ae=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Zi?ae=N.shadow.map.texture:ae=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=V.r*Y,f+=V.g*Y,h+=V.b*Y;else if(N.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(N.sh.coefficients[q],Y);L++}else if(N.isSunLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let K=N.shadow,ne=t.get(N);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),i.sunShadow[g]=ne,i.sunShadowMap[g]=ae;let he=K.getViewportCount();for(let fe=0;fe<he;fe++)i.sunShadowMatrix[y+fe]=K.getMatrix(fe),i.sunShadowCascade[y+fe]=K._cascadeData[fe];y+=he,g++}i.sun[p]=q,p++}else if(N.isDirectionalLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let K=N.shadow,ne=t.get(N);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize=K.mapSize,i.directionalShadow[d]=ne,i.directionalShadowMap[d]=ae,i.directionalShadowMatrix[d]=N.shadow.matrix,C++}i.directional[d]=q,d++}else if(N.isSpotLight){let q=e.get(N);q.position.setFromMatrixPosition(N.matrixWorld),q.color.copy(V).multiplyScalar(Y),q.distance=G,q.coneCos=Math.cos(N.angle),q.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),q.decay=N.decay,i.spot[v]=q;let K=N.shadow;if(N.map&&(i.spotLightMap[w]=N.map,w++,K.updateMatrices(N),N.castShadow&&U++),i.spotLightMatrix[v]=K.matrix,N.castShadow){let ne=t.get(N);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize=K.mapSize,i.spotShadow[v]=ne,i.spotShadowMap[v]=ae,_++}v++}else if(N.isRectAreaLight){let q=e.get(N);q.color.copy(V).multiplyScalar(Y),q.halfWidth.set(N.width*.5,0,0),q.halfHeight.set(0,N.height*.5,0),i.rectArea[T]=q,T++}else if(N.isPointLight){let q=e.get(N);if(q.color.copy(N.color).multiplyScalar(N.intensity),q.distance=N.distance,q.decay=N.decay,N.castShadow){let K=N.shadow,ne=t.get(N);ne.shadowIntensity=K.intensity,ne.shadowBias=K.bias,ne.shadowNormalBias=K.normalBias,ne.shadowRadius=K.radius,ne.shadowMapSize=K.mapSize,ne.shadowCameraNear=K.camera.near,ne.shadowCameraFar=K.camera.far,i.pointShadow[m]=ne,i.pointShadowMap[m]=ae,i.pointShadowMatrix[m]=N.shadow.matrix,A++}i.point[m]=q,m++}else if(N.isHemisphereLight){let q=e.get(N);q.skyColor.copy(N.color).multiplyScalar(Y),q.groundColor.copy(N.groundColor).multiplyScalar(Y),i.hemi[S]=q,S++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=De.LTC_FLOAT_1,i.rectAreaLTC2=De.LTC_FLOAT_2):(i.rectAreaLTC1=De.LTC_HALF_1,i.rectAreaLTC2=De.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let I=i.hash;(I.sunLength!==p||I.directionalLength!==d||I.pointLength!==m||I.spotLength!==v||I.rectAreaLength!==T||I.hemiLength!==S||I.numSunShadows!==g||I.numDirectionalShadows!==C||I.numPointShadows!==A||I.numSpotShadows!==_||I.numSpotMaps!==w||I.numLightProbes!==L)&&(i.sun.length=p,i.directional.length=d,i.spot.length=v,i.rectArea.length=T,i.point.length=m,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+w-U,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=L,I.sunLength=p,I.directionalLength=d,I.pointLength=m,I.spotLength=v,I.rectAreaLength=T,I.hemiLength=S,I.numSunShadows=g,I.numDirectionalShadows=C,I.numPointShadows=A,I.numSpotShadows=_,I.numSpotMaps=w,I.numLightProbes=L,i.version=JE++)}function l(c,u){let f=0,h=0,p=0,g=0,y=0,d=0,m=u.matrixWorldInverse;for(let v=0,T=c.length;v<T;v++){let S=c[v];if(S.isSunLight){let C=i.sun[f];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(m),f++}else if(S.isDirectionalLight){let C=i.directional[h];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),h++}else if(S.isSpotLight){let C=i.spot[g];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),g++}else if(S.isRectAreaLight){let C=i.rectArea[y];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let C=i.point[p];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),p++}else if(S.isHemisphereLight){let C=i.hemi[d];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(m),d++}}}return{setup:a,setupView:l,state:i}}function $g(n){let e=new KE(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function QE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new $g(n),e.set(s,[a])):r>=o.length?(a=new $g(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var eA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,tA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,nA=[new B(1,0,0),new B(-1,0,0),new B(0,1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1)],iA=[new B(0,-1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1),new B(0,-1,0),new B(0,-1,0)],Zg=new vt,Qa=new B,Kf=new B;function sA(n,e,t){let i=new er,s=new ct,r=new ct,o=new Ht,a=new Dc,l=new Uc,c={},u=t.maxTextureSize,f={[or]:ni,[ni]:or,[Ri]:Ri},h=new ai({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ct},radius:{value:4}},vertexShader:eA,fragmentShader:tA}),p=h.clone();p.defines.HORIZONTAL_PASS=1;let g=new mn;g.setAttribute("position",new dn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new be(g,h),d=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ar;let m=this.type;this.render=function(A,_,w){if(d.enabled===!1||d.autoUpdate===!1&&d.needsUpdate===!1||A.length===0)return;this.type===Hm&&(Je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ar);let U=n.getRenderTarget(),L=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),k=n.state;k.setBlending(Tr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let W=m!==this.type;W&&_.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(V=>V.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,V=A.length;N<V;N++){let Y=A[N],G=Y.shadow;if(G===void 0){Je("WebGLShadowMap:",Y,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ae=G.getFrameExtents();s.multiply(ae),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ae.x),s.x=r.x*ae.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ae.y),s.y=r.y*ae.y,G.mapSize.y=r.y));let q=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=q,G.map===null||W===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Lo){if(Y.isPointLight){Je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new _i(s.x,s.y,{format:Zi,type:$i,minFilter:ti,magFilter:ti,generateMipmaps:!1}),G.map.texture.name=Y.name+".shadowMap",G.map.depthTexture=new Ps(s.x,s.y,Pi),G.map.depthTexture.name=Y.name+".shadowMapDepth",G.map.depthTexture.format=Cs,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=On,G.map.depthTexture.magFilter=On}else Y.isPointLight?(G.map=new tl(s.x),G.map.depthTexture=new La(s.x,Yi)):(G.map=new _i(s.x,s.y),G.map.depthTexture=new Ps(s.x,s.y,Yi)),G.map.depthTexture.name=Y.name+".shadowMap",G.map.depthTexture.format=Cs,this.type===Ar?(G.map.depthTexture.compareFunction=q?Vf:Gf,G.map.depthTexture.minFilter=ti,G.map.depthTexture.magFilter=ti):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=On,G.map.depthTexture.magFilter=On);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let K=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Y.isPointLight!==!0&&G.updateMatrices(Y,w);let ne=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:w.layers;for(let he=0;he<K;he++){let fe=G.getCamera(he);if(Y.isPointLight){let Q=G.camera,ge=G.matrix,ve=Y.distance||Q.far;ve!==Q.far&&(Q.far=ve,Q.updateProjectionMatrix()),Qa.setFromMatrixPosition(Y.matrixWorld),Q.position.copy(Qa),Kf.copy(Q.position),Kf.add(nA[he]),Q.up.copy(iA[he]),Q.lookAt(Kf),Q.updateMatrixWorld(),ge.makeTranslation(-Qa.x,-Qa.y,-Qa.z),Zg.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Zg,Q.coordinateSystem,Q.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,he),n.clear();else{he===0&&(n.setRenderTarget(G.map),n.clear());let Q=G.getViewport(he);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),k.viewport(o)}i=G.getFrustum(he),S(_,w,fe,Y,ne,this.type)}G.isPointLightShadow!==!0&&this.type===Lo&&v(G,w),G.needsUpdate=!1}m=this.type,d.needsUpdate=!1,n.setRenderTarget(U,L,I)};function v(A,_){let w=e.update(y);h.defines.VSM_SAMPLES!==A.blurSamples&&(h.defines.VSM_SAMPLES=A.blurSamples,p.defines.VSM_SAMPLES=A.blurSamples,h.needsUpdate=!0,p.needsUpdate=!0),A.mapPass===null?A.mapPass=new _i(s.x,s.y,{format:Zi,type:$i}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),h.uniforms.shadow_pass.value=A.map.depthTexture,h.uniforms.resolution.value.set(A.map.width,A.map.height),h.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(_,null,w,h,y,null),p.uniforms.shadow_pass.value=A.mapPass.texture,p.uniforms.resolution.value.set(A.map.width,A.map.height),p.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(_,null,w,p,y,null)}function T(A,_,w,U){let L=null,I=w.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(I!==void 0)L=I;else if(L=w.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let k=L.uuid,W=_.uuid,N=c[k];N===void 0&&(N={},c[k]=N);let V=N[W];V===void 0&&(V=L.clone(),N[W]=V,_.addEventListener("dispose",C)),L=V}if(L.visible=_.visible,L.wireframe=_.wireframe,U===Lo?L.side=_.shadowSide!==null?_.shadowSide:_.side:L.side=_.shadowSide!==null?_.shadowSide:f[_.side],L.alphaMap=_.alphaMap,L.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,L.map=_.map,L.clipShadows=_.clipShadows,L.clippingPlanes=_.clippingPlanes,L.clipIntersection=_.clipIntersection,L.displacementMap=_.displacementMap,L.displacementScale=_.displacementScale,L.displacementBias=_.displacementBias,L.wireframeLinewidth=_.wireframeLinewidth,L.linewidth=_.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let k=n.properties.get(L);k.light=w}return L}function S(A,_,w,U,L,I){if(A.visible===!1)return;if(A.layers.test(L)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&I===Lo)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,A.matrixWorld);let N=e.update(A),V=A.material;if(Array.isArray(V)){let Y=N.groups;for(let G=0,ae=Y.length;G<ae;G++){let q=Y[G],K=V[q.materialIndex];if(K&&K.visible){let ne=T(A,K,U,I);A.onBeforeShadow(n,A,_,w,N,ne,q),n.renderBufferDirect(w,null,N,ne,A,q),A.onAfterShadow(n,A,_,w,N,ne,q)}}}else if(V.visible){let Y=T(A,V,U,I);A.onBeforeShadow(n,A,_,w,N,Y,null),n.renderBufferDirect(w,null,N,Y,A,null),A.onAfterShadow(n,A,_,w,N,Y,null)}}let W=A.children;for(let N=0,V=W.length;N<V;N++)S(W[N],_,w,U,L,I)}function C(A){A.target.removeEventListener("dispose",C);for(let w in c){let U=c[w],L=A.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function rA(n,e){function t(){let F=!1,se=new Ht,te=null,Ae=new Ht(0,0,0,0);return{setMask:function(_e){te!==_e&&!F&&(n.colorMask(_e,_e,_e,_e),te=_e)},setLocked:function(_e){F=_e},setClear:function(_e,Me,We,Ke,ce){ce===!0&&(_e*=Ke,Me*=Ke,We*=Ke),se.set(_e,Me,We,Ke),Ae.equals(se)===!1&&(n.clearColor(_e,Me,We,Ke),Ae.copy(se))},reset:function(){F=!1,te=null,Ae.set(-1,0,0,0)}}}function i(){let F=!1,se=!1,te=null,Ae=null,_e=null;return{setReversed:function(Me){if(se!==Me){let We=e.get("EXT_clip_control");Me?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),se=Me;let Ke=_e;_e=null,this.setClear(Ke)}},getReversed:function(){return se},setTest:function(Me){Me?we(n.DEPTH_TEST):Xe(n.DEPTH_TEST)},setMask:function(Me){te!==Me&&!F&&(n.depthMask(Me),te=Me)},setFunc:function(Me){if(se&&(Me=bg[Me]),Ae!==Me){switch(Me){case mc:n.depthFunc(n.NEVER);break;case gc:n.depthFunc(n.ALWAYS);break;case _c:n.depthFunc(n.LESS);break;case Mo:n.depthFunc(n.LEQUAL);break;case xc:n.depthFunc(n.EQUAL);break;case vc:n.depthFunc(n.GEQUAL);break;case yc:n.depthFunc(n.GREATER);break;case Sc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ae=Me}},setLocked:function(Me){F=Me},setClear:function(Me){_e!==Me&&(_e=Me,se&&(Me=1-Me),n.clearDepth(Me))},reset:function(){F=!1,te=null,Ae=null,_e=null,se=!1}}}function s(){let F=!1,se=null,te=null,Ae=null,_e=null,Me=null,We=null,Ke=null,ce=null;return{setTest:function(ke){F||(ke?we(n.STENCIL_TEST):Xe(n.STENCIL_TEST))},setMask:function(ke){se!==ke&&!F&&(n.stencilMask(ke),se=ke)},setFunc:function(ke,Qe,Pe){(te!==ke||Ae!==Qe||_e!==Pe)&&(n.stencilFunc(ke,Qe,Pe),te=ke,Ae=Qe,_e=Pe)},setOp:function(ke,Qe,Pe){(Me!==ke||We!==Qe||Ke!==Pe)&&(n.stencilOp(ke,Qe,Pe),Me=ke,We=Qe,Ke=Pe)},setLocked:function(ke){F=ke},setClear:function(ke){ce!==ke&&(n.clearStencil(ke),ce=ke)},reset:function(){F=!1,se=null,te=null,Ae=null,_e=null,Me=null,We=null,Ke=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},p=new WeakMap,g=[],y=null,d=!1,m=null,v=null,T=null,S=null,C=null,A=null,_=null,w=new Ye(0,0,0),U=0,L=!1,I=null,k=null,W=null,N=null,V=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ae=0,q=n.getParameter(n.VERSION);q.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec(q)[1]),G=ae>=1):q.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),G=ae>=2);let K=null,ne={},he=n.getParameter(n.SCISSOR_BOX),fe=n.getParameter(n.VIEWPORT),Q=new Ht().fromArray(he),ge=new Ht().fromArray(fe);function ve(F,se,te,Ae){let _e=new Uint8Array(4),Me=n.createTexture();n.bindTexture(F,Me),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<te;We++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(se,0,n.RGBA,1,1,Ae,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(se+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return Me}let Re={};Re[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),Re[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Re[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),we(n.DEPTH_TEST),o.setFunc(Mo),gn(!1),Ut(Mf),we(n.CULL_FACE),jt(Tr);function we(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function Xe(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function ot(F,se){return h[F]!==se?(n.bindFramebuffer(F,se),h[F]=se,F===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=se),F===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=se),!0):!1}function He(F,se){let te=g,Ae=!1;if(F){te=p.get(se),te===void 0&&(te=[],p.set(se,te));let _e=F.textures;if(te.length!==_e.length||te[0]!==n.COLOR_ATTACHMENT0){for(let Me=0,We=_e.length;Me<We;Me++)te[Me]=n.COLOR_ATTACHMENT0+Me;te.length=_e.length,Ae=!0}}else te[0]!==n.BACK&&(te[0]=n.BACK,Ae=!0);Ae&&n.drawBuffers(te)}function dt(F){return y!==F?(n.useProgram(F),y=F,!0):!1}let ut={[Cr]:n.FUNC_ADD,[Xm]:n.FUNC_SUBTRACT,[qm]:n.FUNC_REVERSE_SUBTRACT};ut[Ym]=n.MIN,ut[$m]=n.MAX;let st={[Zm]:n.ZERO,[Jm]:n.ONE,[jm]:n.SRC_COLOR,[Af]:n.SRC_ALPHA,[ig]:n.SRC_ALPHA_SATURATE,[tg]:n.DST_COLOR,[Qm]:n.DST_ALPHA,[Km]:n.ONE_MINUS_SRC_COLOR,[Tf]:n.ONE_MINUS_SRC_ALPHA,[ng]:n.ONE_MINUS_DST_COLOR,[eg]:n.ONE_MINUS_DST_ALPHA,[sg]:n.CONSTANT_COLOR,[rg]:n.ONE_MINUS_CONSTANT_COLOR,[og]:n.CONSTANT_ALPHA,[ag]:n.ONE_MINUS_CONSTANT_ALPHA};function jt(F,se,te,Ae,_e,Me,We,Ke,ce,ke){if(F===Tr){d===!0&&(Xe(n.BLEND),d=!1);return}if(d===!1&&(we(n.BLEND),d=!0),F!==Wm){if(F!==m||ke!==L){if((v!==Cr||C!==Cr)&&(n.blendEquation(n.FUNC_ADD),v=Cr,C=Cr),ke)switch(F){case No:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case bf:n.blendFunc(n.ONE,n.ONE);break;case wf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Ef:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:et("WebGLState: Invalid blending: ",F);break}else switch(F){case No:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case bf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case wf:et("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ef:et("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:et("WebGLState: Invalid blending: ",F);break}T=null,S=null,A=null,_=null,w.set(0,0,0),U=0,m=F,L=ke}return}_e=_e||se,Me=Me||te,We=We||Ae,(se!==v||_e!==C)&&(n.blendEquationSeparate(ut[se],ut[_e]),v=se,C=_e),(te!==T||Ae!==S||Me!==A||We!==_)&&(n.blendFuncSeparate(st[te],st[Ae],st[Me],st[We]),T=te,S=Ae,A=Me,_=We),(Ke.equals(w)===!1||ce!==U)&&(n.blendColor(Ke.r,Ke.g,Ke.b,ce),w.copy(Ke),U=ce),m=F,L=!1}function Vt(F,se){F.side===Ri?Xe(n.CULL_FACE):we(n.CULL_FACE);let te=F.side===ni;se&&(te=!te),gn(te),F.blending===No&&F.transparent===!1?jt(Tr):jt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Ae=F.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),Mt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?we(n.SAMPLE_ALPHA_TO_COVERAGE):Xe(n.SAMPLE_ALPHA_TO_COVERAGE)}function gn(F){I!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),I=F)}function Ut(F){F!==Gm?(we(n.CULL_FACE),F!==k&&(F===Mf?n.cullFace(n.BACK):F===Vm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Xe(n.CULL_FACE),k=F}function In(F){F!==W&&(G&&n.lineWidth(F),W=F)}function Mt(F,se,te){F?(we(n.POLYGON_OFFSET_FILL),(N!==se||V!==te)&&(N=se,V=te,o.getReversed()&&(se=-se,te=-te),n.polygonOffset(se,te))):Xe(n.POLYGON_OFFSET_FILL)}function En(F){F?we(n.SCISSOR_TEST):Xe(n.SCISSOR_TEST)}function nn(F){F===void 0&&(F=n.TEXTURE0+Y-1),K!==F&&(n.activeTexture(F),K=F)}function _n(F,se,te){te===void 0&&(K===null?te=n.TEXTURE0+Y-1:te=K);let Ae=ne[te];Ae===void 0&&(Ae={type:void 0,texture:void 0},ne[te]=Ae),(Ae.type!==F||Ae.texture!==se)&&(K!==te&&(n.activeTexture(te),K=te),n.bindTexture(F,se||Re[F]),Ae.type=F,Ae.texture=se)}function O(){let F=ne[K];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Ie(){try{n.compressedTexImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function Ze(){try{n.compressedTexImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function at(){try{n.texSubImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function Ee(){try{n.texSubImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function Ot(){try{n.compressedTexSubImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function Ve(){try{n.compressedTexSubImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function $e(){try{n.texStorage2D(...arguments)}catch(F){et("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){et("WebGLState:",F)}}function M(){try{n.texImage2D(...arguments)}catch(F){et("WebGLState:",F)}}function X(){try{n.texImage3D(...arguments)}catch(F){et("WebGLState:",F)}}function ue(F){return f[F]!==void 0?f[F]:n.getParameter(F)}function re(F,se){f[F]!==se&&(n.pixelStorei(F,se),f[F]=se)}function xe(F){Q.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),Q.copy(F))}function ye(F){ge.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),ge.copy(F))}function ee(F,se){let te=c.get(se);te===void 0&&(te=new WeakMap,c.set(se,te));let Ae=te.get(F);Ae===void 0&&(Ae=n.getUniformBlockIndex(se,F.name),n.uniformBlockBinding(se,Ae,Ae),te.set(F,Ae))}function ie(F,se,te){let _e=c.get(se).get(F);l[_e]!==te&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,te),l[_e]=te)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},K=null,ne={},h={},l={},p=new WeakMap,g=[],y=null,d=!1,m=null,v=null,T=null,S=null,C=null,A=null,_=null,w=new Ye(0,0,0),U=0,L=!1,I=null,k=null,W=null,N=null,V=null,Q.set(0,0,n.canvas.width,n.canvas.height),ge.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:we,disable:Xe,bindFramebuffer:ot,drawBuffers:He,useProgram:dt,setBlending:jt,setMaterial:Vt,setFlipSided:gn,setCullFace:Ut,setLineWidth:In,setPolygonOffset:Mt,setScissorTest:En,activeTexture:nn,bindTexture:_n,unbindTexture:O,compressedTexImage2D:Ie,compressedTexImage3D:Ze,texImage2D:M,texImage3D:X,pixelStorei:re,getParameter:ue,updateUBOMapping:ee,uniformBlockBinding:ie,texStorage2D:$e,texStorage3D:R,texSubImage2D:at,texSubImage3D:Ee,compressedTexSubImage2D:Ot,compressedTexSubImage3D:Ve,scissor:xe,viewport:ye,reset:me}}function oA(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ct,u=new WeakMap,f=new Set,h,p=new WeakMap,g=new Set,y=new FinalizationRegistry(R=>g.delete(R)),d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,M){return d?new OffscreenCanvas(R,M):ba("canvas")}function v(R,M,X){let ue=1,re=$e(R);if((re.width>X||re.height>X)&&(ue=X/Math.max(re.width,re.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let xe=Math.floor(ue*re.width),ye=Math.floor(ue*re.height);h===void 0&&(h=m(xe,ye));let ee=M?m(xe,ye):h;return ee.width=xe,ee.height=ye,ee.getContext("2d").drawImage(R,0,0,xe,ye),Je("WebGLRenderer: Texture has been resized from ("+re.width+"x"+re.height+") to ("+xe+"x"+ye+")."),ee}else return"data"in R&&Je("WebGLRenderer: Image in DataTexture is too big ("+re.width+"x"+re.height+")."),R;return R}function T(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(R,M,X,ue,re,xe=!1){if(R!==null){if(n[R]!==void 0)return n[R];Je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||Je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=M;if(M===n.RED&&(X===n.FLOAT&&(ee=n.R32F),X===n.HALF_FLOAT&&(ee=n.R16F),X===n.UNSIGNED_BYTE&&(ee=n.R8),X===n.UNSIGNED_SHORT&&ye&&(ee=ye.R16_EXT),X===n.SHORT&&ye&&(ee=ye.R16_SNORM_EXT)),M===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.R8UI),X===n.UNSIGNED_SHORT&&(ee=n.R16UI),X===n.UNSIGNED_INT&&(ee=n.R32UI),X===n.BYTE&&(ee=n.R8I),X===n.SHORT&&(ee=n.R16I),X===n.INT&&(ee=n.R32I)),M===n.RG&&(X===n.FLOAT&&(ee=n.RG32F),X===n.HALF_FLOAT&&(ee=n.RG16F),X===n.UNSIGNED_BYTE&&(ee=n.RG8),X===n.UNSIGNED_SHORT&&ye&&(ee=ye.RG16_EXT),X===n.SHORT&&ye&&(ee=ye.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RG8UI),X===n.UNSIGNED_SHORT&&(ee=n.RG16UI),X===n.UNSIGNED_INT&&(ee=n.RG32UI),X===n.BYTE&&(ee=n.RG8I),X===n.SHORT&&(ee=n.RG16I),X===n.INT&&(ee=n.RG32I)),M===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGB8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGB16UI),X===n.UNSIGNED_INT&&(ee=n.RGB32UI),X===n.BYTE&&(ee=n.RGB8I),X===n.SHORT&&(ee=n.RGB16I),X===n.INT&&(ee=n.RGB32I)),M===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(ee=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(ee=n.RGBA16UI),X===n.UNSIGNED_INT&&(ee=n.RGBA32UI),X===n.BYTE&&(ee=n.RGBA8I),X===n.SHORT&&(ee=n.RGBA16I),X===n.INT&&(ee=n.RGBA32I)),M===n.RGB&&(X===n.UNSIGNED_SHORT&&ye&&(ee=ye.RGB16_EXT),X===n.SHORT&&ye&&(ee=ye.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(ee=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(ee=n.R11F_G11F_B10F)),M===n.RGBA){let ie=xe?Ma:xt.getTransfer(re);X===n.FLOAT&&(ee=n.RGBA32F),X===n.HALF_FLOAT&&(ee=n.RGBA16F),X===n.UNSIGNED_BYTE&&(ee=ie===Ct?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&ye&&(ee=ye.RGBA16_EXT),X===n.SHORT&&ye&&(ee=ye.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(ee=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(ee=n.RGB5_A1)}return(ee===n.R16F||ee===n.R32F||ee===n.RG16F||ee===n.RG32F||ee===n.RGBA16F||ee===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function _(R,M){let X;return R?M===null||M===Yi||M===Pr?X=n.DEPTH24_STENCIL8:M===Pi?X=n.DEPTH32F_STENCIL8:M===Uo&&(X=n.DEPTH24_STENCIL8,Je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Yi||M===Pr?X=n.DEPTH_COMPONENT24:M===Pi?X=n.DEPTH_COMPONENT32F:M===Uo&&(X=n.DEPTH_COMPONENT16),X}function w(R,M){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==On&&R.minFilter!==ti?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function U(R){let M=new WeakRef(R);i.get(R).__ref=M,g.add(M),y.register(R,M,M)}function L(R){let M=i.get(R).__ref;M!==void 0&&(g.delete(M),y.unregister(M))}function I(R){W(R.target)}function k(R){N(R.target)}function W(R){R.removeEventListener("dispose",I),L(R),Y(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&f.delete(R)}function N(R){R.removeEventListener("dispose",k),L(R),ae(R)}function V(){for(let R of g){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):W(M))}g.clear(),f.clear()}function Y(R){let M=i.get(R);if(M.__webglInit===void 0)return;let X=R.source,ue=p.get(X);if(ue){let re=ue[M.__cacheKey];re.usedTimes--,re.usedTimes===0&&G(R),Object.keys(ue).length===0&&p.delete(X)}i.remove(R)}function G(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let X=R.source,ue=p.get(X);delete ue[M.__cacheKey],o.memory.textures--}function ae(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let X=R.depthTexture;if(X&&X.renderTarget===R&&W(X),R.isWebGLCubeRenderTarget)for(let re=0;re<6;re++){if(Array.isArray(M.__webglFramebuffer[re]))for(let xe=0;xe<M.__webglFramebuffer[re].length;xe++)n.deleteFramebuffer(M.__webglFramebuffer[re][xe]);else n.deleteFramebuffer(M.__webglFramebuffer[re]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[re])}else{if(Array.isArray(M.__webglFramebuffer))for(let re=0;re<M.__webglFramebuffer.length;re++)n.deleteFramebuffer(M.__webglFramebuffer[re]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let re=0;re<M.__webglColorRenderbuffer.length;re++)M.__webglColorRenderbuffer[re]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[re]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=R.textures;for(let re=0,xe=ue.length;re<xe;re++){let ye=i.get(ue[re]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[re])}i.remove(R)}let q=0;function K(){q=0}function ne(){return q}function he(R){q=R}function fe(){let R=q;return R>=s.maxTextures&&Je("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,R}function Q(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function ge(R,M){let X=i.get(R);if(R.isVideoTexture&&Ot(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&X.__version!==R.version){let ue=R.image;if(ue===null)Je("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Je("WebGLRenderer: Texture marked for update but image is incomplete");else{Vt(X,R,M);return}}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+M)}function ve(R,M){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Vt(X,R,M);return}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+M)}function Re(R,M){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Vt(X,R,M);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+M)}function we(R,M){let X=i.get(R);if(R.version>0&&X.__version!==R.version){gn(X,R,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+M)}let Xe={[Mc]:n.REPEAT,[cs]:n.CLAMP_TO_EDGE,[bc]:n.MIRRORED_REPEAT},ot={[On]:n.NEAREST,[ug]:n.NEAREST_MIPMAP_NEAREST,[Wa]:n.NEAREST_MIPMAP_LINEAR,[ti]:n.LINEAR,[jc]:n.LINEAR_MIPMAP_NEAREST,[Ns]:n.LINEAR_MIPMAP_LINEAR},He={[pg]:n.NEVER,[Hf]:n.ALWAYS,[mg]:n.LESS,[Gf]:n.LEQUAL,[gg]:n.EQUAL,[Vf]:n.GEQUAL,[_g]:n.GREATER,[xg]:n.NOTEQUAL};function dt(R,M){if(M.type===Pi&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===ti||M.magFilter===jc||M.magFilter===Wa||M.magFilter===Ns||M.minFilter===ti||M.minFilter===jc||M.minFilter===Wa||M.minFilter===Ns)&&Je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,Xe[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,Xe[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,Xe[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ot[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ot[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,He[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===On||M.minFilter!==Wa&&M.minFilter!==Ns||M.type===Pi&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ut(R,M){let X=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",I),U(M));let ue=M.source,re=p.get(ue);re===void 0&&(re={},p.set(ue,re));let xe=Q(M);if(xe!==R.__cacheKey){re[xe]===void 0&&(re[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),re[xe].usedTimes++;let ye=re[R.__cacheKey];ye!==void 0&&(re[R.__cacheKey].usedTimes--,ye.usedTimes===0&&G(M)),R.__cacheKey=xe,R.__webglTexture=re[xe].texture}return X}function st(R,M,X){return Math.floor(Math.floor(R/X)/M)}function jt(R,M,X,ue){let xe=R.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,X,ue,M.data);else{xe.sort((F,se)=>F.start-se.start);let ye=0;for(let F=1;F<xe.length;F++){let se=xe[ye],te=xe[F],Ae=se.start+se.count,_e=st(te.start,M.width,4),Me=st(se.start,M.width,4);te.start<=Ae+1&&_e===Me&&st(te.start+te.count-1,M.width,4)===_e?se.count=Math.max(se.count,te.start+te.count-se.start):(++ye,xe[ye]=te)}xe.length=ye+1;let ee=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let F=0,se=xe.length;F<se;F++){let te=xe[F],Ae=Math.floor(te.start/4),_e=Math.ceil(te.count/4),Me=Ae%M.width,We=Math.floor(Ae/M.width),Ke=_e,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,Me,We,Ke,ce,X,ue,M.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ee),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function Vt(R,M,X){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let re=ut(R,M),xe=M.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+X);let ye=i.get(xe);if(xe.version!==ye.__version||re===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=xt.getPrimaries(xt.workingColorSpace),ke=M.colorSpace===Us?null:xt.getPrimaries(M.colorSpace),Qe=M.colorSpace===Us||ce===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qe)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let ie=v(M.image,!1,s.maxTextureSize);ie=Ve(M,ie);let me=r.convert(M.format,M.colorSpace),F=r.convert(M.type),se=A(M.internalFormat,me,F,M.normalized,M.colorSpace,M.isVideoTexture);dt(ue,M);let te,Ae=M.mipmaps,_e=M.isVideoTexture!==!0,Me=ye.__version===void 0||re===!0,We=xe.dataReady,Ke=w(M,ie);if(M.isDepthTexture)se=_(M.format===Ds,M.type),Me&&(_e?t.texStorage2D(n.TEXTURE_2D,1,se,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,se,ie.width,ie.height,0,me,F,null));else if(M.isDataTexture)if(Ae.length>0){_e&&Me&&t.texStorage2D(n.TEXTURE_2D,Ke,se,Ae[0].width,Ae[0].height);for(let ce=0,ke=Ae.length;ce<ke;ce++)te=Ae[ce],_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,te.width,te.height,me,F,te.data):t.texImage2D(n.TEXTURE_2D,ce,se,te.width,te.height,0,me,F,te.data);M.generateMipmaps=!1}else _e?(Me&&t.texStorage2D(n.TEXTURE_2D,Ke,se,ie.width,ie.height),We&&jt(M,ie,me,F)):t.texImage2D(n.TEXTURE_2D,0,se,ie.width,ie.height,0,me,F,ie.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){_e&&Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ke,se,Ae[0].width,Ae[0].height,ie.depth);for(let ce=0,ke=Ae.length;ce<ke;ce++)if(te=Ae[ce],M.format!==li)if(me!==null)if(_e){if(We)if(M.layerUpdates.size>0){let Qe=Jf(te.width,te.height,M.format,M.type);for(let Pe of M.layerUpdates){let lt=te.data.subarray(Pe*Qe/te.data.BYTES_PER_ELEMENT,(Pe+1)*Qe/te.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Pe,te.width,te.height,1,me,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,te.width,te.height,ie.depth,me,te.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,se,te.width,te.height,ie.depth,0,te.data,0,0);else Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,te.width,te.height,ie.depth,me,F,te.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,se,te.width,te.height,ie.depth,0,me,F,te.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{_e&&Me&&t.texStorage2D(n.TEXTURE_2D,Ke,se,Ae[0].width,Ae[0].height);for(let ce=0,ke=Ae.length;ce<ke;ce++)te=Ae[ce],M.format!==li?me!==null?_e?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,te.width,te.height,me,te.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,se,te.width,te.height,0,te.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,te.width,te.height,me,F,te.data):t.texImage2D(n.TEXTURE_2D,ce,se,te.width,te.height,0,me,F,te.data)}else if(M.isDataArrayTexture)if(_e){if(Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ke,se,ie.width,ie.height,ie.depth),We)if(M.layerUpdates.size>0){let ce=Jf(ie.width,ie.height,M.format,M.type);for(let ke of M.layerUpdates){let Qe=ie.data.subarray(ke*ce/ie.data.BYTES_PER_ELEMENT,(ke+1)*ce/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,ie.width,ie.height,1,me,F,Qe)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,me,F,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,se,ie.width,ie.height,ie.depth,0,me,F,ie.data);else if(M.isData3DTexture)_e?(Me&&t.texStorage3D(n.TEXTURE_3D,Ke,se,ie.width,ie.height,ie.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,me,F,ie.data)):t.texImage3D(n.TEXTURE_3D,0,se,ie.width,ie.height,ie.depth,0,me,F,ie.data);else if(M.isFramebufferTexture){if(Me)if(_e)t.texStorage2D(n.TEXTURE_2D,Ke,se,ie.width,ie.height);else{let ce=ie.width,ke=ie.height;for(let Qe=0;Qe<Ke;Qe++)t.texImage2D(n.TEXTURE_2D,Qe,se,ce,ke,0,me,F,null),ce>>=1,ke>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),ie.parentNode!==ce){ce.appendChild(ie),f.add(M),ce.onpaint=ke=>{let Qe=ke.changedElements;for(let Pe of f)Qe.includes(Pe.image)&&(Pe.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let Qe=n.RGBA,Pe=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Qe,Pe,lt,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(_e&&Me){let ce=$e(Ae[0]);t.texStorage2D(n.TEXTURE_2D,Ke,se,ce.width,ce.height)}for(let ce=0,ke=Ae.length;ce<ke;ce++)te=Ae[ce],_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,me,F,te):t.texImage2D(n.TEXTURE_2D,ce,se,me,F,te);M.generateMipmaps=!1}else if(_e){if(Me){let ce=$e(ie);t.texStorage2D(n.TEXTURE_2D,Ke,se,ce.width,ce.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,F,ie)}else t.texImage2D(n.TEXTURE_2D,0,se,me,F,ie);T(M)&&M.mipmapsAutoUpdate===!0&&S(ue),ye.__version=xe.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function gn(R,M,X){if(M.image.length!==6)return;let ue=ut(R,M),re=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+X);let xe=i.get(re);if(re.version!==xe.__version||ue===!0){t.activeTexture(n.TEXTURE0+X);let ye=xt.getPrimaries(xt.workingColorSpace),ee=M.colorSpace===Us?null:xt.getPrimaries(M.colorSpace),ie=M.colorSpace===Us||ye===ee?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let me=M.isCompressedTexture||M.image[0].isCompressedTexture,F=M.image[0]&&M.image[0].isDataTexture,se=[];for(let Pe=0;Pe<6;Pe++)!me&&!F?se[Pe]=v(M.image[Pe],!0,s.maxCubemapSize):se[Pe]=F?M.image[Pe].image:M.image[Pe],se[Pe]=Ve(M,se[Pe]);let te=se[0],Ae=r.convert(M.format,M.colorSpace),_e=r.convert(M.type),Me=A(M.internalFormat,Ae,_e,M.normalized,M.colorSpace),We=M.isVideoTexture!==!0,Ke=xe.__version===void 0||ue===!0,ce=re.dataReady,ke=w(M,te);dt(n.TEXTURE_CUBE_MAP,M);let Qe;if(M.isDepthTexture){if(Me=_(M.format===Ds,M.type),Ke)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Me,te.width,te.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Me,te.width,te.height,0,Ae,_e,null)}else if(me){We&&Ke&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Me,te.width,te.height);for(let Pe=0;Pe<6;Pe++){Qe=se[Pe].mipmaps;for(let lt=0;lt<Qe.length;lt++){let Xt=Qe[lt];M.format!==li?Ae!==null?We?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,Xt.width,Xt.height,Ae,Xt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,Me,Xt.width,Xt.height,0,Xt.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,0,0,Xt.width,Xt.height,Ae,_e,Xt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt,Me,Xt.width,Xt.height,0,Ae,_e,Xt.data)}}}else{if(Qe=M.mipmaps,We&&Ke){Qe.length>0&&ke++;let Pe=$e(se[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Me,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(F){We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,se[Pe].width,se[Pe].height,Ae,_e,se[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Me,se[Pe].width,se[Pe].height,0,Ae,_e,se[Pe].data);for(let lt=0;lt<Qe.length;lt++){let $n=Qe[lt].image[Pe].image;We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,$n.width,$n.height,Ae,_e,$n.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,Me,$n.width,$n.height,0,Ae,_e,$n.data)}}else{We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Ae,_e,se[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Me,Ae,_e,se[Pe]);for(let lt=0;lt<Qe.length;lt++){let Xt=Qe[lt];We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,0,0,Ae,_e,Xt.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,lt+1,Me,Ae,_e,Xt.image[Pe])}}}T(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),xe.__version=re.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Ut(R,M,X,ue,re,xe){let ye=r.convert(X.format,X.colorSpace),ee=r.convert(X.type),ie=A(X.internalFormat,ye,ee,X.normalized,X.colorSpace),me=i.get(M),F=i.get(X);if(F.__renderTarget=M,!me.__hasExternalTextures){let se=Math.max(1,M.width>>xe),te=Math.max(1,M.height>>xe);re===n.TEXTURE_3D||re===n.TEXTURE_2D_ARRAY?t.texImage3D(re,xe,ie,se,te,M.depth,0,ye,ee,null):t.texImage2D(re,xe,ie,se,te,0,ye,ee,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Ee(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,re,F.__webglTexture,0,at(M)):(re===n.TEXTURE_2D||re>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&re<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,re,F.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function In(R,M,X){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ue=M.depthTexture,re=ue&&ue.isDepthTexture?ue.type:null,xe=_(M.stencilBuffer,re),ye=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ee(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(M),xe,M.width,M.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(M),xe,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,xe,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,R)}else{let ue=M.textures;for(let re=0;re<ue.length;re++){let xe=ue[re],ye=r.convert(xe.format,xe.colorSpace),ee=r.convert(xe.type),ie=A(xe.internalFormat,ye,ee,xe.normalized,xe.colorSpace);Ee(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(M),ie,M.width,M.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(M),ie,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ie,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Mt(R,M,X){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let re=i.get(M.depthTexture);re.__renderTarget=M;let xe=ue?M.depthTexture.image[0]:M.depthTexture.image;(!re.__webglTexture||xe.width!==M.width||xe.height!==M.height)&&(xe.width=M.width,xe.height=M.height,M.depthTexture.needsUpdate=!0),ue?we(M.depthTexture,0):ge(M.depthTexture,0);let ye=re.__webglTexture,ee=at(M),ie=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,me=M.depthTexture.format===Ds?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===Cs)Ee(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,ie,ye,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,me,ie,ye,0);else if(M.depthTexture.format===Ds)Ee(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,ie,ye,0,ee):n.framebufferTexture2D(n.FRAMEBUFFER,me,ie,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function En(R){let M=i.get(R),X=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let re=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",re)};ue.addEventListener("dispose",re),M.__depthDisposeCallback=re}M.__boundDepthTexture=ue}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(X)for(let ue=0;ue<6;ue++)Mt(M.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?Mt(M.__webglFramebuffer[0],R,0):Mt(M.__webglFramebuffer,R,0);else if(X){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),In(M.__webglDepthbuffer[ue],R,!1);else{let re=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,re,n.RENDERBUFFER,xe)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),In(M.__webglDepthbuffer,R,!1);else{let re=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,re,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function nn(R,M,X){let ue=i.get(R);M!==void 0&&Ut(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&En(R)}function _n(R){let M=R.texture,X=i.get(R),ue=i.get(M);R.addEventListener("dispose",k),U(R);let re=R.textures,xe=R.isWebGLCubeRenderTarget===!0,ye=re.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),xe){X.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(M.mipmaps.length>0){X.__webglFramebuffer[ee]=[];for(let ie=0;ie<M.mipmaps.length;ie++)X.__webglFramebuffer[ee][ie]=n.createFramebuffer()}else X.__webglFramebuffer[ee]=n.createFramebuffer()}else{if(M.mipmaps.length>0){X.__webglFramebuffer=[];for(let ee=0;ee<M.mipmaps.length;ee++)X.__webglFramebuffer[ee]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(ye)for(let ee=0,ie=re.length;ee<ie;ee++){let me=i.get(re[ee]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Ee(R)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let ee=0;ee<re.length;ee++){let ie=re[ee];X.__webglColorRenderbuffer[ee]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[ee]);let me=r.convert(ie.format,ie.colorSpace),F=r.convert(ie.type),se=A(ie.internalFormat,me,F,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),te=at(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,te,se,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ee,n.RENDERBUFFER,X.__webglColorRenderbuffer[ee])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),In(X.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),dt(n.TEXTURE_CUBE_MAP,M);for(let ee=0;ee<6;ee++)if(M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ut(X.__webglFramebuffer[ee][ie],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ie);else Ut(X.__webglFramebuffer[ee],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);T(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let ee=0,ie=re.length;ee<ie;ee++){let me=re[ee],F=i.get(me),se=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(se,F.__webglTexture),dt(se,me),Ut(X.__webglFramebuffer,R,me,n.COLOR_ATTACHMENT0+ee,se,0),T(me)&&S(se)}t.unbindTexture()}else{let ee=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ee=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ee,ue.__webglTexture),dt(ee,M),M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ut(X.__webglFramebuffer[ie],R,M,n.COLOR_ATTACHMENT0,ee,ie);else Ut(X.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,ee,0);T(M)?S(ee):M.mipmaps.length>0&&n.texParameteri(ee,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&En(R)}function O(R){let M=R.textures;for(let X=0,ue=M.length;X<ue;X++){let re=M[X];if(T(re)&&re.mipmapsAutoUpdate===!0){let xe=C(R),ye=i.get(re).__webglTexture;t.bindTexture(xe,ye),S(xe),t.unbindTexture()}}}let Ie=[];function Ze(R){if(R.samples>0){if(Ee(R)===!1){let M=R.textures,X=R.width,ue=R.height,re=n.COLOR_BUFFER_BIT,xe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(R),ee=M.length>1;if(ee)for(let me=0;me<M.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let me=0;me<M.length;me++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(re|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(re|=n.STENCIL_BUFFER_BIT)),ee){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let F=i.get(M[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,X,ue,0,0,X,ue,re,n.NEAREST),l===!0&&(Ie.length=0,Ie.push(n.COLOR_ATTACHMENT0+me),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Ie.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ee)for(let me=0;me<M.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let F=i.get(M[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function at(R){return Math.min(s.maxSamples,R.samples)}function Ee(R){let M=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ot(R){let M=o.render.frame;u.get(R)!==M&&(u.set(R,M),R.update())}function Ve(R,M){let X=R.colorSpace,ue=R.format,re=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||X!==Sa&&X!==Us&&(xt.getTransfer(X)===Ct?(ue!==li||re!==Wn)&&Je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):et("WebGLTextures: Unsupported texture color space:",X)),M}function $e(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=K,this.getTextureUnits=ne,this.setTextureUnits=he,this.setTexture2D=ge,this.setTexture2DArray=ve,this.setTexture3D=Re,this.setTextureCube=we,this.rebindTextures=nn,this.setupRenderTarget=_n,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=En,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=Ee,this.dispose=V}function aA(n,e){function t(i,s=Us){let r,o=xt.getTransfer(s);if(i===Wn)return n.UNSIGNED_BYTE;if(i===Qc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===eu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Of)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Bf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Uf)return n.BYTE;if(i===Ff)return n.SHORT;if(i===Uo)return n.UNSIGNED_SHORT;if(i===Kc)return n.INT;if(i===Yi)return n.UNSIGNED_INT;if(i===Pi)return n.FLOAT;if(i===$i)return n.HALF_FLOAT;if(i===kf)return n.ALPHA;if(i===zf)return n.RGB;if(i===li)return n.RGBA;if(i===Cs)return n.DEPTH_COMPONENT;if(i===Ds)return n.DEPTH_STENCIL;if(i===Fo)return n.RED;if(i===tu)return n.RED_INTEGER;if(i===Zi)return n.RG;if(i===nu)return n.RG_INTEGER;if(i===iu)return n.RGBA_INTEGER;if(i===Xa||i===qa||i===Ya||i===$a)if(o===Ct)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Xa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Xa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===qa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ya)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===$a)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===su||i===ru||i===ou||i===au)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===su)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===ru)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ou)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===au)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===lu||i===cu||i===uu||i===hu||i===fu||i===Za||i===du)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===lu||i===cu)return o===Ct?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===uu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===hu)return r.COMPRESSED_R11_EAC;if(i===fu)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Za)return r.COMPRESSED_RG11_EAC;if(i===du)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===pu||i===mu||i===gu||i===_u||i===xu||i===vu||i===yu||i===Su||i===Mu||i===bu||i===wu||i===Eu||i===Au||i===Tu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===pu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===mu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===gu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===_u)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===xu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===vu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===yu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Su)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Mu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===bu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===wu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Eu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Au)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Tu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Cu||i===Ru||i===Pu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Cu)return o===Ct?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Ru)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Pu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Iu||i===Lu||i===Ja||i===Nu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Iu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Lu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ja)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Nu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Pr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var lA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,cA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,rd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Na(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new ai({vertexShader:lA,fragmentShader:cA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new be(new Ls(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},od=class extends Hi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,p=null,g=null,y=typeof XRWebGLBinding<"u",d=new rd,m={},v=t.getContextAttributes(),T=null,S=null,C=[],A=[],_=new ct,w=null,U=null,L=new ei;L.viewport=new Ht;let I=new ei;I.viewport=new Ht;let k=[L,I],W=new Yc,N=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let ge=C[Q];return ge===void 0&&(ge=new To,C[Q]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(Q){let ge=C[Q];return ge===void 0&&(ge=new To,C[Q]=ge),ge.getGripSpace()},this.getHand=function(Q){let ge=C[Q];return ge===void 0&&(ge=new To,C[Q]=ge),ge.getHandSpace()};function Y(Q){let ge=A.indexOf(Q.inputSource);if(ge===-1)return;let ve=C[ge];ve!==void 0&&(ve.update(Q.inputSource,Q.frame,c||o),ve.dispatchEvent({type:Q.type,data:Q.inputSource}))}function G(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ae);for(let Q=0;Q<C.length;Q++){let ge=A[Q];ge!==null&&(A[Q]=null,C[Q].disconnect(ge))}N=null,V=null,d.reset();for(let Q in m)delete m[Q];if(e.setRenderTarget(T),p=null,h=null,f=null,s=null,S=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(w),e.setSize(_.width,_.height,!1),U!==null){let Q=U.camera;Q.fov=U.fov,Q.zoom=U.zoom,Q.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&Je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&Je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return h!==null?h:p},this.getBinding=function(){return f===null&&y&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ae),v.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Re=null,we=null;v.depth&&(we=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=v.stencil?Ds:Cs,Re=v.stencil?Pr:Yi);let Xe={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(Xe),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new _i(h.textureWidth,h.textureHeight,{format:li,type:Wn,depthTexture:new Ps(h.textureWidth,h.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ve={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new _i(p.framebufferWidth,p.framebufferHeight,{format:li,type:Wn,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),fe.setContext(s),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return d.getDepthTexture()};function ae(Q){for(let ge=0;ge<Q.removed.length;ge++){let ve=Q.removed[ge],Re=A.indexOf(ve);Re>=0&&(A[Re]=null,C[Re].disconnect(ve))}for(let ge=0;ge<Q.added.length;ge++){let ve=Q.added[ge],Re=A.indexOf(ve);if(Re===-1){for(let Xe=0;Xe<C.length;Xe++)if(Xe>=A.length){A.push(ve),Re=Xe;break}else if(A[Xe]===null){A[Xe]=ve,Re=Xe;break}if(Re===-1)break}let we=C[Re];we&&we.connect(ve)}}function q(Q,ge){ge===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(ge.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let ge=Q.near,ve=Q.far;d.texture!==null&&(d.depthNear>0&&(ge=d.depthNear),d.depthFar>0&&(ve=d.depthFar)),W.near=I.near=L.near=ge,W.far=I.far=L.far=ve,(N!==W.near||V!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),N=W.near,V=W.far),W.layers.mask=Q.layers.mask|6,L.layers.mask=W.layers.mask&-5,I.layers.mask=W.layers.mask&-3;let Re=Q.parent,we=W.cameras;q(W,Re);for(let Xe=0;Xe<we.length;Xe++)q(we[Xe],Re);W.projectionMatrix.copy(L.projectionMatrix),W.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&Q.isPerspectiveCamera&&(U={camera:Q,fov:Q.fov,zoom:Q.zoom}),K(Q,W,Re)};function K(Q,ge,ve){ve===null?Q.matrix.copy(ge.matrixWorld):(Q.matrix.copy(ve.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(ge.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(ge.projectionMatrix),Q.projectionMatrixInverse.copy(ge.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Ec*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(h===null&&p===null))return l},this.setFoveation=function(Q){l=Q,h!==null&&(h.fixedFoveation=Q),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=Q)},this.hasDepthSensing=function(){return d.texture!==null},this.getDepthSensingMesh=function(){return d.getMesh(W)},this.getCameraTexture=function(Q){return m[Q]};let ne=null;function he(Q,ge){if(u=ge.getViewerPose(c||o),g=ge,u!==null){let ve=u.views;p!==null&&(e.setRenderTargetFramebuffer(S,p.framebuffer),e.setRenderTarget(S));let Re=!1;ve.length!==W.cameras.length&&(W.cameras.length=0,Re=!0);for(let He=0;He<ve.length;He++){let dt=ve[He],ut=null;if(p!==null)ut=p.getViewport(dt);else{let jt=f.getViewSubImage(h,dt);ut=jt.viewport,He===0&&(e.setRenderTargetTextures(S,jt.colorTexture,jt.depthStencilTexture),e.setRenderTarget(S))}let st=k[He];st===void 0&&(st=new ei,st.layers.enable(He),st.viewport=new Ht,k[He]=st),st.matrix.fromArray(dt.transform.matrix),st.matrix.decompose(st.position,st.quaternion,st.scale),st.projectionMatrix.fromArray(dt.projectionMatrix),st.projectionMatrixInverse.copy(st.projectionMatrix).invert(),st.viewport.set(ut.x,ut.y,ut.width,ut.height),He===0&&(W.matrix.copy(st.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Re===!0&&W.cameras.push(st)}let we=s.enabledFeatures;if(we&&we.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){f=i.getBinding();let He=f.getDepthInformation(ve[0]);He&&He.isValid&&He.texture&&d.init(He,s.renderState)}if(we&&we.includes("camera-access")&&y){e.state.unbindTexture(),f=i.getBinding();for(let He=0;He<ve.length;He++){let dt=ve[He].camera;if(dt){let ut=m[dt];ut||(ut=new Na,m[dt]=ut);let st=f.getCameraImage(dt);ut.sourceTexture=st}}}}for(let ve=0;ve<C.length;ve++){let Re=A[ve],we=C[ve];Re!==null&&we!==void 0&&we.update(Re,ge,c||o)}ne&&ne(Q,ge),ge.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ge}),g=null}let fe=new Jg;fe.setAnimationLoop(he),this.setAnimationLoop=function(Q){ne=Q},this.dispose=function(){}}},uA=new vt,o0=new nt;o0.set(-1,0,0,0,1,0,0,0,1);function hA(n,e){function t(d,m){d.matrixAutoUpdate===!0&&d.updateMatrix(),m.value.copy(d.matrix)}function i(d,m){m.color.getRGB(d.fogColor.value,Yf(n)),m.isFog?(d.fogNear.value=m.near,d.fogFar.value=m.far):m.isFogExp2&&(d.fogDensity.value=m.density)}function s(d,m,v,T,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(d,m):m.isMeshLambertMaterial?(r(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(d,m),f(d,m)):m.isMeshPhongMaterial?(r(d,m),u(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(d,m),h(d,m),m.isMeshPhysicalMaterial&&p(d,m,S)):m.isMeshMatcapMaterial?(r(d,m),g(d,m)):m.isMeshDepthMaterial?r(d,m):m.isMeshDistanceMaterial?(r(d,m),y(d,m)):m.isMeshNormalMaterial?r(d,m):m.isLineBasicMaterial?(o(d,m),m.isLineDashedMaterial&&a(d,m)):m.isPointsMaterial?l(d,m,v,T):m.isSpriteMaterial?c(d,m):m.isShadowMaterial?(d.color.value.copy(m.color),d.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(d,m){d.opacity.value=m.opacity,m.color&&d.diffuse.value.copy(m.color),m.emissive&&d.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(d.map.value=m.map,t(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.bumpMap&&(d.bumpMap.value=m.bumpMap,t(m.bumpMap,d.bumpMapTransform),d.bumpScale.value=m.bumpScale,m.side===ni&&(d.bumpScale.value*=-1)),m.normalMap&&(d.normalMap.value=m.normalMap,t(m.normalMap,d.normalMapTransform),d.normalScale.value.copy(m.normalScale),m.side===ni&&d.normalScale.value.negate()),m.displacementMap&&(d.displacementMap.value=m.displacementMap,t(m.displacementMap,d.displacementMapTransform),d.displacementScale.value=m.displacementScale,d.displacementBias.value=m.displacementBias),m.emissiveMap&&(d.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,d.emissiveMapTransform)),m.specularMap&&(d.specularMap.value=m.specularMap,t(m.specularMap,d.specularMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest);let v=e.get(m),T=v.envMap,S=v.envMapRotation;T&&(d.envMap.value=T,d.envMapRotation.value.setFromMatrix4(uA.makeRotationFromEuler(S)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&d.envMapRotation.value.premultiply(o0),d.reflectivity.value=m.reflectivity,d.ior.value=m.ior,d.refractionRatio.value=m.refractionRatio),m.lightMap&&(d.lightMap.value=m.lightMap,d.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,d.lightMapTransform)),m.aoMap&&(d.aoMap.value=m.aoMap,d.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,d.aoMapTransform))}function o(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,m.map&&(d.map.value=m.map,t(m.map,d.mapTransform))}function a(d,m){d.dashSize.value=m.dashSize,d.totalSize.value=m.dashSize+m.gapSize,d.scale.value=m.scale}function l(d,m,v,T){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.size.value=m.size*v,d.scale.value=T*.5,m.map&&(d.map.value=m.map,t(m.map,d.uvTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function c(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.rotation.value=m.rotation,m.map&&(d.map.value=m.map,t(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,t(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function u(d,m){d.specular.value.copy(m.specular),d.shininess.value=Math.max(m.shininess,1e-4)}function f(d,m){m.gradientMap&&(d.gradientMap.value=m.gradientMap)}function h(d,m){d.metalness.value=m.metalness,m.metalnessMap&&(d.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,d.metalnessMapTransform)),d.roughness.value=m.roughness,m.roughnessMap&&(d.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,d.roughnessMapTransform)),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)}function p(d,m,v){d.ior.value=m.ior,m.diffuseRoughness>0&&(d.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(d.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,d.diffuseRoughnessMapTransform))),m.sheen>0&&(d.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),d.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(d.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,d.sheenColorMapTransform)),m.sheenRoughnessMap&&(d.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,d.sheenRoughnessMapTransform))),m.clearcoat>0&&(d.clearcoat.value=m.clearcoat,d.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(d.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,d.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(d.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,d.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(d.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,d.clearcoatNormalMapTransform),d.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ni&&d.clearcoatNormalScale.value.negate())),m.dispersion>0&&(d.dispersion.value=m.dispersion),m.retroreflectivity>0&&(d.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(d.iridescence.value=m.iridescence,d.iridescenceIOR.value=m.iridescenceIOR,d.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,d.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(d.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,d.iridescenceMapTransform)),m.iridescenceThicknessMap&&(d.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,d.iridescenceThicknessMapTransform))),m.transmission>0&&(d.transmission.value=m.transmission,d.transmissionSamplerMap.value=v.texture,d.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(d.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,d.transmissionMapTransform)),d.thickness.value=m.thickness,m.thicknessMap&&(d.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,d.thicknessMapTransform)),d.attenuationDistance.value=m.attenuationDistance,d.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(d.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(d.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,d.anisotropyMapTransform))),d.specularIntensity.value=m.specularIntensity,d.specularColor.value.copy(m.specularColor),m.specularColorMap&&(d.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,d.specularColorMapTransform)),m.specularIntensityMap&&(d.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,d.specularIntensityMapTransform))}function g(d,m){m.matcap&&(d.matcap.value=m.matcap)}function y(d,m){let v=e.get(m).light;d.referencePosition.value.setFromMatrixPosition(v.matrixWorld),d.nearDistance.value=v.shadow.camera.near,d.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function fA(n,e,t,i){let s={},r={};function o(v,T){let S=T.program;i.uniformBlockBinding(v,S,s[v.id])}function a(v,T){let S=s[v.id];S===void 0&&(g(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",d));let C=T.program;i.updateUBOMapping(v,C);let A=e.render.frame;r[v.id]!==A&&(c(v),r[v.id]=A)}function l(v){let T=n.createBuffer(),S=v.__size,C=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,S,C),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(v){let T=s[v.id],S=v.uniforms,C=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let A=0,_=S.length;A<_;A++){let w=S[A];if(Array.isArray(w))for(let U=0,L=w.length;U<L;U++)u(w[U],A,U,C);else u(w,A,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,T,S,C){if(h(v,T,S,C)===!0){let A=v.__offset,_=v.value;if(Array.isArray(_)){let w=0;for(let U=0;U<_.length;U++){let L=_[U],I=y(L,!0);f(L,v.__data,w),w+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else f(_,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,v.__data)}}function f(v,T,S){typeof v=="number"||typeof v=="boolean"?T[S]=v:v.isMatrix3?(T[S]=v.elements[0],T[S+1]=v.elements[1],T[S+2]=v.elements[2],T[S+3]=0,T[S+4]=v.elements[3],T[S+5]=v.elements[4],T[S+6]=v.elements[5],T[S+7]=0,T[S+8]=v.elements[6],T[S+9]=v.elements[7],T[S+10]=v.elements[8],T[S+11]=0):ArrayBuffer.isView(v)?T.set(v.subarray(0,T.length-S),S):v.toArray(T,S)}function h(v,T,S,C){let A=v.value,_=T+"_"+S;if(Array.isArray(A)){C[_]===void 0&&(C[_]=[]);let w=C[_],U=!1;for(let L=0;L<A.length;L++)p(A[L],w,L)===!0&&(U=!0);return U}return p(A,C,_)}function p(v,T,S){if(T[S]===void 0)return typeof v=="number"||typeof v=="boolean"?T[S]=v:ArrayBuffer.isView(v)?T[S]=v.slice():T[S]=v.clone(),!0;{let C=T[S];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return T[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function g(v){let T=v.uniforms,S=0,C=16;for(let _=0,w=T.length;_<w;_++){let U=Array.isArray(T[_])?T[_]:[T[_]];for(let L=0,I=U.length;L<I;L++){let k=U[L],W=Array.isArray(k.value)?k.value:[k.value],N=Array.isArray(T[_])||Array.isArray(k.value),V=S;for(let G=0,ae=W.length;G<ae;G++){let q=W[G],K=y(q,N),ne=S%C,he=ne%K.boundary,fe=ne+he;S+=he,fe!==0&&C-fe<K.storage&&(S+=C-fe),G===0&&(V=S),S+=K.storage}let Y=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new Y((S-V)/Float32Array.BYTES_PER_ELEMENT),k.__offset=V}}let A=S%C;return A>0&&(S+=C-A),v.__size=S,v.__cache={},this}function y(v,T){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Je("WebGLRenderer: Unsupported uniform value type.",v),T===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function d(v){let T=v.target;T.removeEventListener("dispose",d),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function m(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var dA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ds=null;function pA(){return ds===null&&(ds=new wr(dA,16,16,Zi,$i),ds.name="DFG_LUT",ds.minFilter=ti,ds.magFilter=ti,ds.wrapS=cs,ds.wrapT=cs,ds.generateMipmaps=!1,ds.needsUpdate=!0),ds}var Ou=class{constructor(e={}){let{canvas:t=yg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:p=Wn}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let y=p,d=new Set([iu,nu,tu]),m=new Set([Wn,Yi,Uo,Pr,Qc,eu]),v=new Uint32Array(4),T=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,A=null,_=[],w=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=fs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,I=!1,k=null,W=null,N=null,V=null;this._outputColorSpace=Qn;let Y=0,G=0,ae=null,q=-1,K=null,ne=new Ht,he=new Ht,fe=null,Q=new Ye(0),ge=0,ve=t.width,Re=t.height,we=1,Xe=null,ot=null,He=new Ht(0,0,ve,Re),dt=new Ht(0,0,ve,Re),ut=!1,st=new er,jt=new Rc,Vt=!1,gn=!1,Ut=new vt,In=new B,Mt=new Ht,En={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},nn=!1;function _n(){return ae===null?we:1}let O=i;function Ie(E,z){return t.getContext(E,z)}let Ze,at,Ee,Ot,Ve,$e,R,M,X,ue,re,xe,ye,ee,ie,me,F,se,te,Ae,_e,Me,We;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",Qe,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),O===null){let z="webgl2";if(O=Ie(z,E),O===null)throw Ie(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ke()}catch(E){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),et("WebGLRenderer: "+E.message),E}function Ke(){Ze=new E1(O),Ze.init(),_e=new aA(O,Ze),at=new p1(O,Ze,e,_e),Ee=new rA(O,Ze),at.reversedDepthBuffer&&h&&Ee.buffers.depth.setReversed(!0),W=O.createFramebuffer(),N=O.createFramebuffer(),V=O.createFramebuffer(),Ot=new C1(O),Ve=new XE,$e=new oA(O,Ze,Ee,Ve,at,_e,Ot),R=new w1(L),M=new PM(O),Me=new f1(O,M),X=new A1(O,M,Ot,Me),ue=new P1(O,X,M,Me,Ot),se=new R1(O,at,$e),ie=new m1(Ve),re=new WE(L,R,Ze,at,Me,ie),xe=new hA(L,Ve),ye=new YE,ee=new QE(Ze),F=new h1(L,R,Ee,ue,g,l),me=new sA(L,ue,at),We=new fA(O,Ot,at,Ee),te=new d1(O,Ze,Ot),Ae=new T1(O,Ze,Ot),Ot.programs=re.programs,L.capabilities=at,L.extensions=Ze,L.properties=Ve,L.renderLists=ye,L.shadowMap=me,L.state=Ee,L.info=Ot}y!==Wn&&(U=new L1(y,t.width,t.height,a,s,r));let ce=new od(L,O);this.xr=ce,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let E=Ze.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Ze.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(E){E!==void 0&&(we=E,this.setSize(ve,Re,!1))},this.getSize=function(E){return E.set(ve,Re)},this.setSize=function(E,z,j=!0){if(ce.isPresenting){Je("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=E,Re=z,t.width=Math.floor(E*we),t.height=Math.floor(z*we),j===!0&&(t.style.width=E+"px",t.style.height=z+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,E,z)},this.getDrawingBufferSize=function(E){return E.set(ve*we,Re*we).floor()},this.setDrawingBufferSize=function(E,z,j){ve=E,Re=z,we=j,t.width=Math.floor(E*j),t.height=Math.floor(z*j),this.setViewport(0,0,E,z)},this.setEffects=function(E){if(y===Wn){et("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let z=0;z<E.length;z++)if(E[z].isOutputPass===!0){Je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(ne)},this.getViewport=function(E){return E.copy(He)},this.setViewport=function(E,z,j,$){E.isVector4?He.set(E.x,E.y,E.z,E.w):He.set(E,z,j,$),Ee.viewport(ne.copy(He).multiplyScalar(_n()).round())},this.getScissor=function(E){return E.copy(dt)},this.setScissor=function(E,z,j,$){E.isVector4?dt.set(E.x,E.y,E.z,E.w):dt.set(E,z,j,$),Ee.scissor(he.copy(dt).multiplyScalar(_n()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(E){Ee.setScissorTest(ut=E)},this.setOpaqueSort=function(E){Xe=E},this.setTransparentSort=function(E){ot=E},this.getClearColor=function(E){return E.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(E=!0,z=!0,j=!0){let $=0;if(E){let Z=!1;if(ae!==null){let Te=ae.texture.format;Z=d.has(Te)}if(Z){let Te=ae.texture.type,Le=m.has(Te),Ce=F.getClearColor(),Ne=F.getClearAlpha(),Ge=Ce.r,tt=Ce.g,pt=Ce.b;Le?(v[0]=Ge,v[1]=tt,v[2]=pt,v[3]=Ne,O.clearBufferuiv(O.COLOR,0,v)):(T[0]=Ge,T[1]=tt,T[2]=pt,T[3]=Ne,O.clearBufferiv(O.COLOR,0,T))}else $|=O.COLOR_BUFFER_BIT}z&&($|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&O.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),k=E},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),F.dispose(),ye.dispose(),ee.dispose(),$e.dispose(),Ve.dispose(),R.dispose(),ue.dispose(),X.dispose(),Me.dispose(),We.dispose(),re.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",zl),ce.removeEventListener("sessionend",ts),_s.stop()};function ke(E){E.preventDefault(),Xf("WebGLRenderer: Context Lost."),I=!0}function Qe(){Xf("WebGLRenderer: Context Restored."),I=!1;let E=Ot.autoReset,z=me.enabled,j=me.autoUpdate,$=me.needsUpdate,Z=me.type;Ke(),Ot.autoReset=E,me.enabled=z,me.autoUpdate=j,me.needsUpdate=$,me.type=Z}function Pe(E){et("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function lt(E){let z=E.target;z.removeEventListener("dispose",lt),Xt(z)}function Xt(E){$n(E),Ve.remove(E)}function $n(E){let z=Ve.get(E).programs;z!==void 0&&(z.forEach(function(j){re.releaseProgram(j)}),E.isShaderMaterial&&re.releaseShaderCache(E))}this.renderBufferDirect=function(E,z,j,$,Z,Te){z===null&&(z=En);let Le=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ce=aa(E,z,j,$,Z);Ee.setMaterial($,Le);let Ne=j.index,Ge=1;if($.wireframe===!0){if(Ne=X.getWireframeAttribute(j),Ne===void 0)return;Ge=2}let tt=j.drawRange,pt=j.attributes.position,ze=tt.start*Ge,mt=(tt.start+tt.count)*Ge;Te!==null&&(ze=Math.max(ze,Te.start*Ge),mt=Math.min(mt,(Te.start+Te.count)*Ge)),Ne!==null?(ze=Math.max(ze,0),mt=Math.min(mt,Ne.count)):pt!=null&&(ze=Math.max(ze,0),mt=Math.min(mt,pt.count));let tn=mt-ze;if(tn<0||tn===1/0)return;Me.setup(Z,$,Ce,j,Ne);let It,Lt=te;if(Ne!==null&&(It=M.get(Ne),Lt=Ae,Lt.setIndex(It)),Z.isMesh)$.wireframe===!0?(Ee.setLineWidth($.wireframeLinewidth*_n()),Lt.setMode(O.LINES)):Lt.setMode(O.TRIANGLES);else if(Z.isLine){let An=$.linewidth;An===void 0&&(An=1),Ee.setLineWidth(An*_n()),Z.isLineSegments?Lt.setMode(O.LINES):Z.isLineLoop?Lt.setMode(O.LINE_LOOP):Lt.setMode(O.LINE_STRIP)}else Z.isPoints?Lt.setMode(O.POINTS):Z.isSprite&&Lt.setMode(O.TRIANGLES);if(Z.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Lt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let An=Z._multiDrawStarts,Oe=Z._multiDrawCounts,xn=Z._multiDrawCount,_t=Ne?M.get(Ne).bytesPerElement:1,vs=Ve.get($).currentProgram.getUniforms();for(let vn=0;vn<xn;vn++)vs.setValue(O,"_gl_DrawID",vn),Lt.render(An[vn]/_t,Oe[vn])}else if(Z.isInstancedMesh)Lt.renderInstances(ze,tn,Z.count);else if(j.isInstancedBufferGeometry){let An=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Oe=Math.min(j.instanceCount,An);Lt.renderInstances(ze,tn,Oe)}else Lt.render(ze,tn)};function sa(E,z,j,$){k!==null&&E.isNodeMaterial&&k.setObject($,E),Vt===!0&&ie.setState(E,j,!1),E.transparent===!0&&E.side===Ri&&E.forceSinglePass===!1?(E.side=ni,E.needsUpdate=!0,ns(E,z,$),E.side=or,E.needsUpdate=!0,ns(E,z,$),E.side=Ri):ns(E,z,$)}this.compile=function(E,z,j=null){j===null&&(j=E),k!==null&&k.renderStart(E,z,j),A=ee.get(j),A.init(z),w.push(A),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),E!==j&&E.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(A.pushLight(Z),Z.castShadow&&A.pushShadow(Z))}),A.setupLights(),k!==null&&k.updateLights(A.state.lightsArray),gn=this.localClippingEnabled,Vt=ie.init(this.clippingPlanes,gn),Vt===!0&&ie.setGlobalState(this.clippingPlanes,z),k!==null&&me.render(A.state.shadowsArray,j,z);let $=new Set;return E.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Te=Z.material;if(Te)if(Array.isArray(Te))for(let Le=0;Le<Te.length;Le++){let Ce=Te[Le];sa(Ce,j,z,Z),$.add(Ce)}else sa(Te,j,z,Z),$.add(Te)}),A=w.pop(),k!==null&&k.renderEnd(),$},this.compileAsync=function(E,z,j=null){let $=this.compile(E,z,j);return new Promise(Z=>{function Te(){if($.forEach(function(Le){let Ne=Ve.get(Le).currentProgram;(Ne===void 0||Ne.isReady())&&$.delete(Le)}),$.size===0){Z(E);return}setTimeout(Te,10)}Ze.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Zr=null;function Dh(E){Zr&&Zr(E)}function zl(){_s.stop()}function ts(){_s.start()}let _s=new Jg;_s.setAnimationLoop(Dh),typeof self<"u"&&_s.setContext(self),this.setAnimationLoop=function(E){Zr=E,ce.setAnimationLoop(E),E===null?_s.stop():_s.start()},ce.addEventListener("sessionstart",zl),ce.addEventListener("sessionend",ts),this.render=function(E,z){if(z!==void 0&&z.isCamera!==!0){et("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;k!==null&&k.renderStart(E,z);let j=ce.enabled===!0&&ce.isPresenting===!0,$=U!==null&&(ae===null||j)&&U.begin(L,ae);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(z),z=ce.getCamera()),E.isScene===!0&&E.onBeforeRender(L,E,z,ae),A=ee.get(E,w.length),A.init(z),A.state.textureUnits=$e.getTextureUnits(),w.push(A),Ut.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?jt.setFromArrayCamera(z):st.setFromProjectionMatrix(Ut,Ti,z.reversedDepth),gn=this.localClippingEnabled,Vt=ie.init(this.clippingPlanes,gn),C=ye.get(E,_.length),C.init(),_.push(C),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Le=L.xr.getDepthSensingMesh();Le!==null&&xs(Le,z,-1/0,L.sortObjects)}xs(E,z,0,L.sortObjects),C.finish(),k!==null&&k.updateLights(A.state.lightsArray),L.sortObjects===!0&&C.sort(Xe,ot),nn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,nn&&F.addToRenderList(C,E),this.info.autoReset===!0&&this.info.reset(),Vt===!0&&ie.beginShadows();let Z=A.state.shadowsArray;if(me.render(Z,E,z),Vt===!0&&ie.endShadows(),($&&U.hasRenderPass())===!1){let Le=C.opaque,Ce=C.transmissive;if(A.setupLights(),z.isArrayCamera){let Ne=z.cameras;if(Ce.length>0)for(let Ge=0,tt=Ne.length;Ge<tt;Ge++){let pt=Ne[Ge];Fi(Le,Ce,E,pt)}nn&&F.render(E);for(let Ge=0,tt=Ne.length;Ge<tt;Ge++){let pt=Ne[Ge];ra(C,E,pt,pt.viewport)}}else Ce.length>0&&Fi(Le,Ce,E,z),nn&&F.render(E),ra(C,E,z)}ae!==null&&G===0&&($e.updateMultisampleRenderTarget(ae),$e.updateRenderTargetMipmap(ae)),$&&U.end(L),E.isScene===!0&&E.onAfterRender(L,E,z),Me.resetDefaultState(),q=-1,K=null,w.pop(),w.length>0?(A=w[w.length-1],$e.setTextureUnits(A.state.textureUnits),Vt===!0&&ie.setGlobalState(L.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,k!==null&&k.renderEnd()};function xs(E,z,j,$){if(E.visible===!1)return;if(E.layers.test(z.layers)){if(E.isGroup)j=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(z);else if(E.isLight)A.pushLight(E),E.castShadow&&A.pushShadow(E);else if(E.isSprite){let Le=z.isArrayCamera?jt:st;if(!E.frustumCulled||E.intersectsFrustum(Le)){$&&Mt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Ut);let Ce=ue.update(E),Ne=E.material;Ne.visible&&C.push(E,Ce,Ne,j,Mt.z,null,z)}}else if(E.isMesh||E.isLine||E.isPoints){let Le=z.isArrayCamera?jt:st;if(!E.frustumCulled||E.intersectsFrustum(Le)){let Ce=ue.update(E),Ne=E.material;if($&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Mt.copy(E.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),Mt.copy(Ce.boundingSphere.center)),Mt.applyMatrix4(E.matrixWorld).applyMatrix4(Ut)),Array.isArray(Ne)){let Ge=Ce.groups;for(let tt=0,pt=Ge.length;tt<pt;tt++){let ze=Ge[tt],mt=Ne[ze.materialIndex];mt&&mt.visible&&C.push(E,Ce,mt,j,Mt.z,ze,z)}}else Ne.visible&&C.push(E,Ce,Ne,j,Mt.z,null,z)}}}let Te=E.children;for(let Le=0,Ce=Te.length;Le<Ce;Le++)xs(Te[Le],z,j,$)}function ra(E,z,j,$){let{opaque:Z,transmissive:Te,transparent:Le}=E;A.setupLightsView(j),Vt===!0&&ie.setGlobalState(L.clippingPlanes,j),$&&Ee.viewport(ne.copy($)),Z.length>0&&sn(Z,z,j),Te.length>0&&sn(Te,z,j),Le.length>0&&sn(Le,z,j),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Fi(E,z,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[$.id]===void 0){let ze=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[$.id]=new _i(1,1,{generateMipmaps:!0,type:ze?$i:Wn,minFilter:Ns,samples:Math.max(4,at.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xt.workingColorSpace})}let Te=A.state.transmissionRenderTarget[$.id],Le=$.viewport||ne;Te.setSize(Le.z*L.transmissionResolutionScale,Le.w*L.transmissionResolutionScale);let Ce=L.getRenderTarget(),Ne=L.getActiveCubeFace(),Ge=L.getActiveMipmapLevel();L.setRenderTarget(Te),L.getClearColor(Q),ge=L.getClearAlpha(),ge<1&&L.setClearColor(16777215,.5),L.clear(),nn&&F.render(j);let tt=L.toneMapping;L.toneMapping=fs;let pt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),A.setupLightsView($),Vt===!0&&ie.setGlobalState(L.clippingPlanes,$),sn(E,j,$),$e.updateMultisampleRenderTarget(Te),$e.updateRenderTargetMipmap(Te),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let mt=0,tn=z.length;mt<tn;mt++){let It=z[mt],{object:Lt,geometry:An,material:Oe,group:xn}=It;if(Oe.side===Ri&&Lt.layers.test($.layers)){let _t=Oe.side;Oe.side=ni,Oe.needsUpdate=!0,hn(Lt,j,$,An,Oe,xn),Oe.side=_t,Oe.needsUpdate=!0,ze=!0}}ze===!0&&($e.updateMultisampleRenderTarget(Te),$e.updateRenderTargetMipmap(Te))}L.setRenderTarget(Ce,Ne,Ge),L.setClearColor(Q,ge),pt!==void 0&&($.viewport=pt),L.toneMapping=tt}function sn(E,z,j){let $=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,Te=E.length;Z<Te;Z++){let Le=E[Z],{object:Ce,geometry:Ne,group:Ge}=Le,tt=Le.material;tt.allowOverride===!0&&$!==null&&(tt=$),Ce.layers.test(j.layers)&&hn(Ce,z,j,Ne,tt,Ge)}}function hn(E,z,j,$,Z,Te){k!==null&&Z.isNodeMaterial&&k.setObject(E,Z),E.onBeforeRender(L,z,j,$,Z,Te),E.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),Z.onBeforeRender(L,z,j,$,E,Te),Z.transparent===!0&&Z.side===Ri&&Z.forceSinglePass===!1?(Z.side=ni,Z.needsUpdate=!0,L.renderBufferDirect(j,z,$,Z,E,Te),Z.side=or,Z.needsUpdate=!0,L.renderBufferDirect(j,z,$,Z,E,Te),Z.side=Ri):L.renderBufferDirect(j,z,$,Z,E,Te),E.onAfterRender(L,z,j,$,Z,Te)}function fn(E){let z=0;for(let j of E)j.texture!==null&&z++;return z}function ns(E,z,j){z.isScene!==!0&&(z=En);let $=Ve.get(E),Z=A.state.lights,Te=A.state.shadowsArray,Le=Z.state.version,Ce=re.getParameters(E,Z.state,Te,z,j,A.state.lightProbeGridArray),Ne=re.getProgramCacheKey(Ce),Ge=$.programs;$.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?z.environment:null,$.fog=z.fog;let tt=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;$.envMap=R.get(E.envMap||$.environment,tt),$.envMapRotation=$.environment!==null&&E.envMap===null?z.environmentRotation:E.envMapRotation,Ge===void 0&&(E.addEventListener("dispose",lt),Ge=new Map,$.programs=Ge,$.programVariants=new Map);let pt=Ge.get(Ne);if(pt!==void 0){if($.currentProgram===pt&&$.lightsStateVersion===Le)return oa(E,Ce),pt}else Ce.uniforms=re.getUniforms(E),k!==null&&E.isNodeMaterial&&k.build(E,j,Ce),E.onBeforeCompile(Ce,L),pt=re.acquireProgram(Ce,Ne),Ge.set(Ne,pt),$.uniforms=Ce.uniforms;let ze=$.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(ze.clippingPlanes=ie.uniform),oa(E,Ce),$.needsLights=Hs(E),$.lightsStateVersion=Le,$.needsLights&&(ze.ambientLightColor.value=Z.state.ambient,ze.lightProbe.value=Z.state.probe,ze.sunLights.value=Z.state.sun,ze.sunLightShadows.value=Z.state.sunShadow,ze.directionalLights.value=Z.state.directional,ze.directionalLightShadows.value=Z.state.directionalShadow,ze.spotLights.value=Z.state.spot,ze.spotLightShadows.value=Z.state.spotShadow,ze.rectAreaLights.value=Z.state.rectArea,ze.ltc_1.value=Z.state.rectAreaLTC1,ze.ltc_2.value=Z.state.rectAreaLTC2,ze.pointLights.value=Z.state.point,ze.pointLightShadows.value=Z.state.pointShadow,ze.hemisphereLights.value=Z.state.hemi,ze.sunShadowMatrix.value=Z.state.sunShadowMatrix,ze.sunShadowCascade.value=Z.state.sunShadowCascade,ze.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,ze.spotLightMatrix.value=Z.state.spotLightMatrix,ze.spotLightMap.value=Z.state.spotLightMap,ze.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=fn(A.state.lightProbeGridArray),$.currentProgram=pt,$.uniformsList=null,pt}function hi(E,z,j,$,Z){let Te=Ve.get(E),Le=Te.currentProgram.id+","+$+","+Z,Ce=Te.programVariants.get(Le);return Ce===void 0?(Ce=ns(E,z,j),Te.programVariants.set(Le,Ce)):(Te.currentProgram=Ce,Te.uniformsList=null,Te.outputColorSpace=$,Te.toneMapping=Z),Ce}function Vs(E){if(E.uniformsList===null){let z=E.currentProgram.getUniforms();E.uniformsList=Oo.seqWithValue(z.seq,E.uniforms)}return E.uniformsList}function oa(E,z){let j=Ve.get(E);j.outputColorSpace=z.outputColorSpace,j.batching=z.batching,j.batchingColor=z.batchingColor,j.instancing=z.instancing,j.instancingColor=z.instancingColor,j.instancingMorph=z.instancingMorph,j.skinning=z.skinning,j.morphTargets=z.morphTargets,j.morphNormals=z.morphNormals,j.morphColors=z.morphColors,j.morphTargetsCount=z.morphTargetsCount,j.numClippingPlanes=z.numClippingPlanes,j.numIntersection=z.numClipIntersection,j.vertexAlphas=z.vertexAlphas,j.vertexTangents=z.vertexTangents,j.toneMapping=z.toneMapping}function aa(E,z,j,$,Z){z.isScene!==!0&&(z=En),$e.resetTextureUnits();let Te=z.fog,Le=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?z.environment:null,Ce=ae===null?L.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:xt.workingColorSpace,Ne=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Ge=R.get($.envMap||Le,Ne),tt=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,pt=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),ze=!!j.morphAttributes.position,mt=!!j.morphAttributes.normal,tn=!!j.morphAttributes.color,It=fs;$.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(It=L.toneMapping);let Lt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,An=Lt!==void 0?Lt.length:0,Oe=Ve.get($),xn=A.state.lights;if(Vt===!0&&(gn===!0||E!==K)){let Nt=E===K&&$.id===q;ie.setState($,E,Nt)}let _t=!1,vs=!1;$.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==xn.state.version||Z.isBatchedMesh&&Oe.batching===!1||!Z.isBatchedMesh&&Oe.batching===!0||Z.isBatchedMesh&&Oe.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Oe.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Oe.instancing===!1||!Z.isInstancedMesh&&Oe.instancing===!0||Z.isSkinnedMesh&&Oe.skinning===!1||!Z.isSkinnedMesh&&Oe.skinning===!0||Z.isInstancedMesh&&Oe.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Oe.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Oe.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Oe.instancingMorph===!1&&Z.morphTexture!==null||Oe.envMap!==Ge||$.fog===!0&&Oe.fog!==Te||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==ie.numPlanes||Oe.numIntersection!==ie.numIntersection)||Oe.vertexAlphas!==tt||Oe.vertexTangents!==pt||Oe.morphTargets!==ze||Oe.morphNormals!==mt||Oe.morphColors!==tn||Oe.morphTargetsCount!==An||Oe.numLightProbeGrids!==fn(A.state.lightProbeGridArray)?_t=!0:(Oe.outputColorSpace!==Ce||Oe.toneMapping!==It)&&(vs=!0):(_t=!0,Oe.__version=$.version);let vn=Oe.currentProgram;(_t===!0||vs===!0)&&(vn=vs===!0?hi($,z,Z,Ce,It):ns($,z,Z),k&&$.isNodeMaterial&&k.onUpdateProgram($,vn,Oe));let Kr=!1,is=!1,ys=!1,ht=vn.getUniforms(),rn=Oe.uniforms;if(Ee.useProgram(vn.program)&&(Kr=!0,is=!0,ys=!0),$.id!==q&&(q=$.id,is=!0),Kr||K!==E){Ee.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ht.setValue(O,"projectionMatrix",E.projectionMatrix),ht.setValue(O,"viewMatrix",E.matrixWorldInverse);let yn=ht.map.cameraPosition;yn!==void 0&&yn.setValue(O,In.setFromMatrixPosition(E.matrixWorld)),at.logarithmicDepthBuffer&&ht.setValue(O,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&ht.setValue(O,"isOrthographic",E.isOrthographicCamera===!0),K!==E&&(K=E,is=!0,ys=!0)}if(Oe.needsLights&&(xn.state.sunShadowMap.length>0&&ht.setValue(O,"sunShadowMap",xn.state.sunShadowMap,$e),xn.state.directionalShadowMap.length>0&&ht.setValue(O,"directionalShadowMap",xn.state.directionalShadowMap,$e),xn.state.spotShadowMap.length>0&&ht.setValue(O,"spotShadowMap",xn.state.spotShadowMap,$e),xn.state.pointShadowMap.length>0&&ht.setValue(O,"pointShadowMap",xn.state.pointShadowMap,$e)),Z.isSkinnedMesh){ht.setOptional(O,Z,"bindMatrix"),ht.setOptional(O,Z,"bindMatrixInverse");let Nt=Z.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),ht.setValue(O,"boneTexture",Nt.boneTexture,$e))}Z.isBatchedMesh&&(ht.setOptional(O,Z,"batchingTexture"),ht.setValue(O,"batchingTexture",Z._matricesTexture,$e),ht.setOptional(O,Z,"batchingIdTexture"),ht.setValue(O,"batchingIdTexture",Z._indirectTexture,$e),ht.setOptional(O,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ht.setValue(O,"batchingColorTexture",Z._colorsTexture,$e));let Zn=j.morphAttributes;if((Zn.position!==void 0||Zn.normal!==void 0||Zn.color!==void 0)&&se.update(Z,j,vn),(is||Oe.receiveShadow!==Z.receiveShadow)&&(Oe.receiveShadow=Z.receiveShadow,ht.setValue(O,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&z.environment!==null&&(rn.envMapIntensity.value=z.environmentIntensity),rn.dfgLUT!==void 0&&(rn.dfgLUT.value=pA()),is){if(ht.setValue(O,"toneMappingExposure",L.toneMappingExposure),Oe.needsLights&&Jr(rn,ys),Te&&$.fog===!0&&xe.refreshFogUniforms(rn,Te),xe.refreshMaterialUniforms(rn,$,we,Re,A.state.transmissionRenderTarget[E.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let Nt=S,yn=0;for(let Gn of A.state.lightProbeGridArray)Gn.texture!==null&&(Nt.textures[yn]=Gn.texture,Nt.min[yn]=Gn.boundingBox.min,Nt.max[yn]=Gn.boundingBox.max,Nt.resolution[yn]=Gn.resolution,yn++);for(let Gn in Nt)Nt[Gn].length=yn;rn.probesSH.value=Nt.textures,rn.probesMin.value=Nt.min,rn.probesMax.value=Nt.max,rn.probesResolution.value=Nt.resolution}Oo.upload(O,Vs(Oe),rn,$e)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Oo.upload(O,Vs(Oe),rn,$e),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&ht.setValue(O,"center",Z.center),ht.setValue(O,"modelViewMatrix",Z.modelViewMatrix),ht.setValue(O,"normalMatrix",Z.normalMatrix),ht.setValue(O,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Nt=$.uniformsGroups;for(let yn=0,Gn=Nt.length;yn<Gn;yn++){let Gl=Nt[yn];We.update(Gl,vn),We.bind(Gl,vn)}}return vn}function Jr(E,z){E.ambientLightColor.needsUpdate=z,E.lightProbe.needsUpdate=z,E.sunLights.needsUpdate=z,E.sunLightShadows.needsUpdate=z,E.directionalLights.needsUpdate=z,E.directionalLightShadows.needsUpdate=z,E.pointLights.needsUpdate=z,E.pointLightShadows.needsUpdate=z,E.spotLights.needsUpdate=z,E.spotLightShadows.needsUpdate=z,E.rectAreaLights.needsUpdate=z,E.hemisphereLights.needsUpdate=z}function Hs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(E,z,j){let $=Ve.get(E);$.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Ve.get(E.texture).__webglTexture=z,Ve.get(E.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,z){let j=Ve.get(E);j.__webglFramebuffer=z,j.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(E,z=0,j=0){ae=E,Y=z,G=j;let $=null,Z=!1,Te=!1;if(E){let Ce=Ve.get(E);if(Ce.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(O.FRAMEBUFFER,Ce.__webglFramebuffer),ne.copy(E.viewport),he.copy(E.scissor),fe=E.scissorTest,Ee.viewport(ne),Ee.scissor(he),Ee.setScissorTest(fe),q=-1;return}else if(Ce.__webglFramebuffer===void 0)$e.setupRenderTarget(E);else if(Ce.__hasExternalTextures)$e.rebindTextures(E,Ve.get(E.texture).__webglTexture,Ve.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let tt=E.depthTexture;if(Ce.__boundDepthTexture!==tt){if(tt!==null&&Ve.has(tt)&&(E.width!==tt.image.width||E.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(E)}}let Ne=E.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Te=!0);let Ge=Ve.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ge[z])?$=Ge[z][j]:$=Ge[z],Z=!0):E.samples>0&&$e.useMultisampledRTT(E)===!1?$=Ve.get(E).__webglMultisampledFramebuffer:Array.isArray(Ge)?$=Ge[j]:$=Ge,ne.copy(E.viewport),he.copy(E.scissor),fe=E.scissorTest}else ne.copy(He).multiplyScalar(we).floor(),he.copy(dt).multiplyScalar(we).floor(),fe=ut;if(j!==0&&($=W),Ee.bindFramebuffer(O.FRAMEBUFFER,$)&&Ee.drawBuffers(E,$),Ee.viewport(ne),Ee.scissor(he),Ee.setScissorTest(fe),Z){let Ce=Ve.get(E.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ce.__webglTexture,j)}else if(Te){let Ce=z;for(let Ne=0;Ne<E.textures.length;Ne++){let Ge=Ve.get(E.textures[Ne]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Ne,Ge.__webglTexture,j,Ce)}}else if(E!==null&&j!==0){let Ce=Ve.get(E.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ce.__webglTexture,j)}q=-1};function jr(E){let z=Ve.get(E);return(z.__readFormat!==E.format||z.__readType!==E.type)&&(z.__readFormat=E.format,z.__readType=E.type,z.__formatReadable=at.textureFormatReadable(E.format),z.__typeReadable=at.textureTypeReadable(E.type)),z}this.readRenderTargetPixels=function(E,z,j,$,Z,Te,Le,Ce=0){if(!(E&&E.isWebGLRenderTarget)){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Ve.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Ee.bindFramebuffer(O.FRAMEBUFFER,Ne);try{let Ge=E.textures[Ce],tt=Ge.format,pt=Ge.type;E.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ce);let ze=jr(Ge);if(ze.__formatReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){et("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=E.width-$&&j>=0&&j<=E.height-Z&&O.readPixels(z,j,$,Z,_e.convert(tt),_e.convert(pt),Te)}finally{let Ge=ae!==null?Ve.get(ae).__webglFramebuffer:null;Ee.bindFramebuffer(O.FRAMEBUFFER,Ge)}}},this.readRenderTargetPixelsAsync=async function(E,z,j,$,Z,Te,Le,Ce=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Ve.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Le!==void 0&&(Ne=Ne[Le],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(z>=0&&z<=E.width-$&&j>=0&&j<=E.height-Z){Ee.bindFramebuffer(O.FRAMEBUFFER,Ne);let Ge=E.textures[Ce],tt=Ge.format,pt=Ge.type;E.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ce);let ze=jr(Ge);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,mt),O.bufferData(O.PIXEL_PACK_BUFFER,Te.byteLength,O.STREAM_READ),O.readPixels(z,j,$,Z,_e.convert(tt),_e.convert(pt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let tn=ae!==null?Ve.get(ae).__webglFramebuffer:null;Ee.bindFramebuffer(O.FRAMEBUFFER,tn);let It=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await Mg(O,It,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,mt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Te),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(mt),O.deleteSync(It),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,z=null,j=0){let $=Math.pow(2,-j),Z=Math.floor(E.image.width*$),Te=Math.floor(E.image.height*$),Le=z!==null?z.x:0,Ce=z!==null?z.y:0;$e.setTexture2D(E,0),O.copyTexSubImage2D(O.TEXTURE_2D,j,0,0,Le,Ce,Z,Te),Ee.unbindTexture()},this.copyTextureToTexture=function(E,z,j=null,$=null,Z=0,Te=0){let Le,Ce,Ne,Ge,tt,pt,ze,mt,tn,It=E.isCompressedTexture?E.mipmaps[Te]:E.image;if(j!==null)Le=j.max.x-j.min.x,Ce=j.max.y-j.min.y,Ne=j.isBox3?j.max.z-j.min.z:1,Ge=j.min.x,tt=j.min.y,pt=j.isBox3?j.min.z:0;else{let ht=Math.pow(2,-Z);Le=Math.floor(It.width*ht),Ce=Math.floor(It.height*ht),E.isDataArrayTexture?Ne=It.depth:E.isData3DTexture?Ne=Math.floor(It.depth*ht):Ne=1,Ge=0,tt=0,pt=0}$!==null?(ze=$.x,mt=$.y,tn=$.z):(ze=0,mt=0,tn=0);let Lt=_e.convert(z.format),An=_e.convert(z.type),Oe;z.isData3DTexture?($e.setTexture3D(z,0),Oe=O.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?($e.setTexture2DArray(z,0),Oe=O.TEXTURE_2D_ARRAY):($e.setTexture2D(z,0),Oe=O.TEXTURE_2D),Ee.activeTexture(O.TEXTURE0),Ee.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,z.flipY),Ee.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Ee.pixelStorei(O.UNPACK_ALIGNMENT,z.unpackAlignment);let xn=Ee.getParameter(O.UNPACK_ROW_LENGTH),_t=Ee.getParameter(O.UNPACK_IMAGE_HEIGHT),vs=Ee.getParameter(O.UNPACK_SKIP_PIXELS),vn=Ee.getParameter(O.UNPACK_SKIP_ROWS),Kr=Ee.getParameter(O.UNPACK_SKIP_IMAGES);Ee.pixelStorei(O.UNPACK_ROW_LENGTH,It.width),Ee.pixelStorei(O.UNPACK_IMAGE_HEIGHT,It.height),Ee.pixelStorei(O.UNPACK_SKIP_PIXELS,Ge),Ee.pixelStorei(O.UNPACK_SKIP_ROWS,tt),Ee.pixelStorei(O.UNPACK_SKIP_IMAGES,pt);let is=E.isDataArrayTexture||E.isData3DTexture,ys=z.isDataArrayTexture||z.isData3DTexture;if(E.isDepthTexture){let ht=Ve.get(E),rn=Ve.get(z),Zn=Ve.get(ht.__renderTarget),Nt=Ve.get(rn.__renderTarget);Ee.bindFramebuffer(O.READ_FRAMEBUFFER,Zn.__webglFramebuffer),Ee.bindFramebuffer(O.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let yn=0;yn<Ne;yn++)is&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ve.get(E).__webglTexture,Z,pt+yn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ve.get(z).__webglTexture,Te,tn+yn)),O.blitFramebuffer(Ge,tt,Ge+Le,tt+Ce,ze,mt,ze+Le,mt+Ce,O.DEPTH_BUFFER_BIT,O.NEAREST);Ee.bindFramebuffer(O.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(Z!==0||E.isRenderTargetTexture||Ve.has(E)){let ht=Ve.get(E),rn=Ve.get(z);Ee.bindFramebuffer(O.READ_FRAMEBUFFER,N),Ee.bindFramebuffer(O.DRAW_FRAMEBUFFER,V);for(let Zn=0;Zn<Ne;Zn++)is?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ht.__webglTexture,Z,pt+Zn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ht.__webglTexture,Z),ys?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,rn.__webglTexture,Te,tn+Zn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,rn.__webglTexture,Te),Z!==0?O.blitFramebuffer(Ge,tt,Ge+Le,tt+Ce,ze,mt,ze+Le,mt+Ce,O.COLOR_BUFFER_BIT,O.NEAREST):ys?O.copyTexSubImage3D(Oe,Te,ze,mt,tn+Zn,Ge,tt,Le,Ce):O.copyTexSubImage2D(Oe,Te,ze,mt,Ge,tt,Le,Ce);Ee.bindFramebuffer(O.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else ys?E.isDataTexture||E.isData3DTexture?O.texSubImage3D(Oe,Te,ze,mt,tn,Le,Ce,Ne,Lt,An,It.data):z.isCompressedArrayTexture?O.compressedTexSubImage3D(Oe,Te,ze,mt,tn,Le,Ce,Ne,Lt,It.data):O.texSubImage3D(Oe,Te,ze,mt,tn,Le,Ce,Ne,Lt,An,It):E.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Te,ze,mt,Le,Ce,Lt,An,It.data):E.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Te,ze,mt,It.width,It.height,Lt,It.data):O.texSubImage2D(O.TEXTURE_2D,Te,ze,mt,Le,Ce,Lt,An,It);Ee.pixelStorei(O.UNPACK_ROW_LENGTH,xn),Ee.pixelStorei(O.UNPACK_IMAGE_HEIGHT,_t),Ee.pixelStorei(O.UNPACK_SKIP_PIXELS,vs),Ee.pixelStorei(O.UNPACK_SKIP_ROWS,vn),Ee.pixelStorei(O.UNPACK_SKIP_IMAGES,Kr),Te===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&O.generateMipmap(Oe),Ee.unbindTexture()},this.initRenderTarget=function(E){Ve.get(E).__webglFramebuffer===void 0&&$e.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?$e.setTextureCube(E,0):E.isData3DTexture?$e.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?$e.setTexture2DArray(E,0):$e.setTexture2D(E,0),Ee.unbindTexture()},this.resetState=function(){Y=0,G=0,ae=null,Ee.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}};function a0(){let n={camera:new ei(30,1,.01,100),target:new B,home:null,azimuth:.75,elevation:.4,distance:4.2,changed:!0,pushed:null};return n.home={azimuth:n.azimuth,elevation:n.elevation,distance:n.distance},Ji(n),n}function Ji(n){let e=n.distance*Math.cos(n.elevation);n.camera.up.set(0,0,1),n.camera.position.set(n.target.x+e*Math.cos(n.azimuth),n.target.y+e*Math.sin(n.azimuth),n.target.z+n.distance*Math.sin(n.elevation)),n.camera.lookAt(n.target),n.camera.updateMatrixWorld(),n.changed=!0}function ad(n,e,t){n.azimuth-=.006*e,n.elevation=Math.max(-1.5,Math.min(1.5,n.elevation+.006*t)),Ji(n)}function l0(n,[e,t,i]){n.azimuth=e===0&&t===0?-Math.PI/2:Math.atan2(t,e),n.elevation=Math.max(-1.5,Math.min(1.5,Math.atan2(i,Math.hypot(e,t)))),Ji(n)}function ko(n,e){n.distance=Math.max(.3,Math.min(30,n.distance*e)),Ji(n)}function ld(n,e,t,i){let{right:s,up:r}=ar(n),o=il(n,n.distance,i);n.target.addScaledVector(s,-e*o).addScaledVector(r,t*o),Ji(n)}var mA=5;function cd(n,e){let t=n.pushed;if(n.pushed=e,!t||!e)return;let[i,s,r]=e.position.map((u,f)=>mA*(u-t.position[f])),o=new At(...t.quat_xyzw),a=new At(...e.quat_xyzw).multiply(o.invert()),l=a.w<0?-2:2,c=ar(n);n.target.addScaledVector(c.right,-s*n.distance).addScaledVector(c.up,-r*n.distance),n.distance=Math.max(.3,Math.min(30,n.distance*Math.exp(-i))),n.azimuth-=l*a.z,n.elevation=Math.max(-1.5,Math.min(1.5,n.elevation+l*a.y)),Ji(n)}function zu(n){Object.assign(n,n.home),n.target.set(0,0,0),Ji(n)}function ar(n){let e=new B,t=new B,i=new B;return n.camera.matrixWorld.extractBasis(e,t,i),{right:e,up:t,forward:i.negate()}}function il(n,e,t){return 2*Math.tan(n.camera.fov*Math.PI/360)*e/Math.max(1,t)}function sl(n,e){let{forward:t}=ar(n);return Math.max(.05,e.clone().sub(n.camera.position).dot(t))}var gA={pause:"M8 5v14M16 5v14",play:"M8 5l11 7-11 7z",step:"M6 5l8 7-8 7zM18 5v14",reset:"M5 12a7 7 0 1 0 2.3-5.2M5 4v4.5h4.5",record:"M12 12m-5.5 0a5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0-11 0",stop:"M7 7h10v10H7z",theme:"M12 4a8 8 0 1 0 0 16zM12 4a8 8 0 0 1 0 16",help:"M9 9a3 3 0 1 1 4.2 2.75c-.8.4-1.2 1-1.2 2.25M12 17.5v.5",fit:"M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",levels:"M12 4l8 14H4zM8 11h8M12 4v14",ghost:"M6 20V10a6 6 0 0 1 12 0v10l-3-2-3 2-3-2zM10 10v.5M14 10v.5",contacts:"M4 16h16M8 16v-6M16 16v-6M6 12l2-2.5 2 2.5M14 12l2-2.5 2 2.5",forces:"M5 19L19 5M19 5h-7M19 5v7",sound:"M4 10v4h3l5 4V6l-5 4zM15.5 9a4 4 0 0 1 0 6M18 6.5a8 8 0 0 1 0 11",names:"M4 5h9l7 7-7 7H4zM8 12h.5",open:"M3 18V6h6l2 2.5h10V18z",headset:"M3 8.5A1.5 1.5 0 0 1 4.5 7h15A1.5 1.5 0 0 1 21 8.5v7a1.5 1.5 0 0 1-1.5 1.5H16l-2.5-2.5h-3L8 17H4.5A1.5 1.5 0 0 1 3 15.5zM7.5 11.5h2M14.5 11.5h2",room:"M3 8.5A1.5 1.5 0 0 1 4.5 7h15A1.5 1.5 0 0 1 21 8.5v7a1.5 1.5 0 0 1-1.5 1.5H16l-2.5-2.5h-3L8 17H4.5A1.5 1.5 0 0 1 3 15.5zM12 3v2M12 19v2",save:"M12 4v11M7 11l5 5 5-5M5 20h14",hand:"M8 12V6a1.5 1.5 0 0 1 3 0v5V4.5a1.5 1.5 0 0 1 3 0V11V6a1.5 1.5 0 0 1 3 0v8c0 4-2 6-5.5 6S7 18 6 15l-1-2.5c-.5-1.5 1.5-2.3 2.2-1z"};function Gu(n){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",gA[n]),e.append(t),e}function ci(n,e,t,i){let s=Object.assign(document.createElement("button"),{type:"button",className:`icon ${n}`});return s.append(Gu(n)),zo(s,e,t),s.addEventListener("click",()=>i(s)),s}function zo(n,e,t){n.title=t?`${e} (${t})`:e,n.setAttribute("aria-label",e)}function rl(n,e){n.dataset.icon!==e&&(n.dataset.icon=e,n.replaceChildren(Gu(e)))}var ud=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function hd(n,e,t=1e-6){if(n==null||!Number.isFinite(n))return{number:"–",unit:e};let i=Math.abs(n);if(i<.005*t)return{number:"0",unit:e};let[s,r]=ud[ud.length-1];for(let[o,a]of ud)if(i>=.9995*o||o<=t){[s,r]=[o,a];break}return{number:Ii(n/s),unit:r+e}}function Ii(n){let e=Math.abs(n);return n.toFixed(e<9.995?2:e<99.95?1:0)}function qn(n,e,t){let{number:i,unit:s}=hd(n,e,t);return i==="–"?i:`${i} ${s}`}function Lr(n){if(!Number.isFinite(n))return"–";if(n<60)return`${n.toFixed(1)} s`;let e=Math.floor(n);return`${Math.floor(e/60)}:${String(e%60).padStart(2,"0")} min`}function ii(n,e,t=`${e}s`){return`${n} ${n===1?e:t}`}var _A={device_lost:"the hand was lost",watchdog:"the haptic loop stood still",not_finite:"a number was not finite",too_fast:"the hand moved too fast",pose_jump:"the hand jumped",turned_too_fast:"the hand turned too fast",orientation_jump:"the hand's direction jumped",contact_stale:"the contact model was too old"},xA={grasped:"The hand took hold of the object",released:"The hand let the object go",armed:"Forces are on",disarmed:"Forces are off",late:"Late",recording_ended:"The recording has ended",not_armed:"Forces stay off",resumed:"Goes on",parameter:"Parameter changed",fault:"Fault",held_back:"Held back",squeezed:"Squeezed"},fd={fault:"ended by a fault",duration:"reached its duration",device_finished:"the hand has finished",stopped:"was stopped"},vA={hand:"simulated hand",web:"mouse or touch",script:"scripted hand",replay:"recorded hand",null:"no hand","":"a recording"};function c0(n){return vA[String(n).split(":")[0]]??n}function Nr(n){return _A[n]??String(n).replaceAll("_"," ")}function Vu({reason:n,fault:e}){let t=fd[n];return!t||n!=="fault"||!e?t:`${t}: ${Nr(e.name)}${e.text?` (${e.text})`:""}`}function u0(n,e){return!n||!(e-n.time<6)?null:`The computer was late (${n.count===1?"once":`${n.count} times so far`}): ${n.text??Nr(n.name)}.`}function Hu({kind:n,detail:e,text:t}){let i=xA[n]??String(n).replaceAll("_"," "),r=[n==="fault"||n==="late"?Nr(e):n==="held_back"?"":e,t].filter(Boolean).join("; ");return r?`${i}: ${r}`:i}function h0(n){let{object:e,statics:t,grasped:i,contacts:s,clusters:r}=n,o=`The ${e}`;if(s===0)return`${o} ${i?"is in the hand and":"rests and"} touches nothing.`;let a=t.length===1?`the ${t[0]}`:"the scene",l=s===1?"1 contact":`${s} contacts`,c=r===0?"":r===1?" in 1 cluster":` in ${r} clusters`;return n.touching&&n.armed===!1?`${o} touches ${a} at ${l}${c}; forces are off.`:n.touching?`${o} presses on ${a} at ${l}${c}.`:`${o} is close to ${a}: ${l}${c}.`}function f0(n){let{object:e,statics:t,rows:i,pressing:s}=n,r=t.length===1?`the ${t[0]}`:"the scene";if(i===0)return`The ${e} ${n.grasped?"is in the hand and":"rests and"} touches nothing.`;if(s===0)return`The ${e} is close to ${r}: ${i===1?"1 row":`${i} rows`} near, none presses.`;let o=`The ${e} rests on ${s===1?"1 row":`${s} rows`} of ${r}`;return n.armed===!1?`${o}; forces are off.`:`${o}; the hand pulls ${n.newtons}${n.stiffness?`; coupling ${n.stiffness}`:""}.`}function d0({pressing:n,stiffness:e,stretch:t,force:i,heldBack:s,squeezed:r,say:o}){if(r>.1)return"Squeezed: surfaces all around are nearer than the gap that is kept; move it back the way it came.";if(s>.01)return`Held back in ${Math.round(100*s)} % of the last second: the object waits where its contact model ends; move it more slowly.`;if(!(n>0)||!(e>0))return"Nothing limits the object but the coupling.";let a=e*t,l=`${o(e,"N/m")} × ${o(t,"m")}`;return i<.9*a?`The coupling alone limits the force: ${l} would be ${o(a,"N")}; it has levelled off, or the device is at its limit.`:`The coupling alone limits the force: ${l}. The surfaces do not give.`}function p0(n){return n.filter(({presses:e,friction:t,force:i,normal:s})=>{let r=i.reduce((a,l,c)=>a+l*s[c],0),o=Math.hypot(...i.map((a,l)=>a-r*s[l]));return e&&t>0&&o>.98*t*Math.abs(r)}).length}var yA=["what a hand feels","speed","what the eye sees","the cap on deviation","the budget"];function m0(n){return yA.map((i,s)=>[i,n.filter(r=>r.decidedBy===s).length]).filter(([,i])=>i>0).sort(([,i],[,s])=>s-i).map(([i,s])=>`${Math.round(100*s/n.length)} % by ${i}`).join(", ")}function dd(n){let e=new Map;for(let{objectLevel:t}of n)e.set(t,(e.get(t)??0)+1);return[...e].sort(([t],[i])=>t-i)}function g0(n){return n.length>0?[...n.map(({ending:e})=>e),".tex",".mcap"].join(","):""}function _0(n){return`Drop meshes${n.length>0?` (${n.map(({name:t})=>t).join(", ")})`:""}, a texture (.tex), or a recording or a scene in one file (.mcap) anywhere on the page, or click to choose.`}function x0(n){let e=document.getElementById("controls"),t=document.getElementById("view-tools"),i={title:document.getElementById("title"),chip:document.getElementById("state"),open:ci("open","Open a scene or a mesh","O",n.open),pause:ci("pause","Pause","P",n.pause),step:ci("step","One step",".",n.step),reset:ci("reset","Begin again","R",n.reset),record:ci("record","Record","",n.record),theme:ci("theme","Light or dark","",n.theme),help:ci("help","Help","?",n.help),device:document.createElement("select"),views:{},headset:{},act:n};i.device.title="Who moves the object",i.device.setAttribute("aria-label",i.device.title),i.device.addEventListener("change",()=>n.device(i.device.value));let s=(...o)=>{let a=Object.assign(document.createElement("span"),{className:"group"});return a.append(...o),a};e.append(s(i.open),s(i.device),s(i.pause,i.step,i.reset,i.record),s(i.theme,i.help));let r=[["levels","Levels of detail: finest as wireframe","L","wireframe"],["ghost","Ghost of the hand","G","ghost"],["contacts","Contacts and clusters","C","contacts"],["forces","Force and torque","A","forces"],["names","Names of the objects","N","names"]];for(let[o,a,l,c]of r)i.views[c]=ci(o,a,l,()=>n.view(c)),t.append(i.views[c]);return i.sound=ci("sound","Sound of contact","S",n.sound),md(i,!1),t.append(i.sound,ci("fit","Fit the view","F",n.fit)),i}function v0(n,e,t){for(let[i,s]of e)n.headset[i]=ci(i==="immersive-ar"?"room":"headset",s,"",()=>t(i)),document.getElementById("view-tools").append(n.headset[i]);pd(n,null)}function pd(n,e){for(let[t,i]of Object.entries(n.headset))i.setAttribute("aria-pressed",String(t===e))}function md(n,e){n.sound.setAttribute("aria-pressed",String(e))}function gd(n,e){for(let[t,i]of Object.entries(n.views))i.setAttribute("aria-pressed",String(e[t]))}function y0(n,e){let{state:t,scene:i,shown:s,connected:r}=e;n.title.textContent=i?.title??"",document.title=i?`${i.title} · Thigma`:"Thigma";let o=r?t?.run??"connecting":"lost",a=s?` · ${Lr(s.time)}`:"",l={lost:"connection lost",connecting:"connecting",running:`running${a}`,paused:`paused${a}`,ended:e.progress?"preparing":fd[t?.reason]??"ended"};t?.late&&(l.running+=` · late ${t.late.count}×`);let c=o==="running"&&(s?.bits&4)!==0;t?.replay&&o==="running"&&(l.running=`replaying${a}`),n.chip.textContent=c?`forces off: ${Nr(e.faultName())}`:l[o],n.chip.title=o==="ended"?Vu(t)??"":t?.late?.text??"",n.chip.dataset.run=c?"fault":o;let u=r&&!!t,f=t?.run==="paused";rl(n.pause,f?"play":"pause"),zo(n.pause,f?"Go on":"Pause","P"),n.pause.disabled=!u||t.run==="ended",n.step.disabled=!u||!f,n.reset.disabled=n.record.disabled=n.open.disabled=!u;let h=!!t?.recording;rl(n.record,h?"stop":"record"),n.record.classList.toggle("on",h),zo(n.record,h?`Stop recording ${t.recording}`:"Record from the start",""),SA(n,t,u)}function SA(n,e,t){let i=[...new Set([...e?.devices??[],...e?[e.device]:[]])];n.device.dataset.uris!==i.join(" ")&&(n.device.dataset.uris=i.join(" "),n.device.replaceChildren(...i.map(s=>new Option(c0(s),s)))),n.device.hidden=i.length===0,n.device.disabled=!t||i.length<2,e&&document.activeElement!==n.device&&(n.device.value=e.device)}function S0(n,e){let t=e?`${e.text}|${e.button??""}`:"";if(n.dataset.key===t||(n.dataset.key=t,n.hidden=!e,!e))return;let i=Object.assign(document.createElement("span"),{textContent:e.text});if(n.className=`hint ${e.mood??""}`,n.replaceChildren(...e.icon?[Gu(e.icon)]:[],i),!e.button)return;let s=Object.assign(document.createElement("button"),{type:"button",textContent:e.button});s.addEventListener("click",e.act),n.append(s)}function M0(){return{step:0,turned:!1,unarmedSince:null,touchedAt:null}}function b0(n,e,t,i){let{state:s,scene:r,snapshot:o}=e;if(!e.connected||!s||!r||!o)return null;let a=r.object.name,l=(o.bits&32)!==0,c=(o.bits&1)!==0,u=(o.bits&2)!==0,f=(o.bits&4)!==0;if(e.progress)return null;let h=e.hello?.may_control===!1;if(s.run==="ended")return{text:`The session ${Vu(s)??"has ended"}.`,button:h?void 0:"Begin again",act:i.reset,mood:"stop"};if(e.refusal&&t.now<e.refusal.until)return{text:e.refusal.text,mood:"stop"};if(h)return{text:"This page watches. To do more, open the address with its token, as the program has printed it."};if(s.replay)return{text:`A recording: ${s.replay.file.split("/").pop()}`,button:s.devices.includes("web:")?"Take it yourself":void 0,act:()=>i.device("web:")};if(f){let g=s.device.startsWith("web:");return{text:`Forces are off: ${Nr(e.faultName())}.${g?` Take hold of the ${a} again to go on.`:""}`,button:g?void 0:"Begin again",act:i.reset,mood:"stop"}}let p=u0(s.late,o.time);return p?{text:p,mood:"stop"}:s.device.startsWith("web:")?s.holder==="other"?{text:"Another page holds the hand; this one watches."}:MA(n,{object:a,grasped:c,armed:u,fading:l,snapshot:o,scene:r,...t}):s.devices.includes("web:")?{text:`A ${s.simulated===!1?"device":"simulated hand"} moves the ${a}.`,button:"Take it yourself",act:()=>i.device("web:"),icon:"hand"}:null}function MA(n,e){let{object:t,grasped:i,armed:s,now:r,newtons:o}=e;if(!i||!e.holding)return n.unarmedSince=null,{text:`Drag the blue ${t}.`,icon:"hand"};if(s?n.unarmedSince=null:n.unarmedSince??=r,!s&&r-n.unarmedSince>.6)return{text:`Taken hold of inside a contact: lift the ${t} off once, then forces come on.`};if(e.fading)return{text:"This page is slow: the force fades until it keeps up, and comes back by itself."};if(o>0&&(n.touchedAt??=r),n.touchedAt===null){let a=e.scene.statics[0]?.name??"scene",l=e.touch?"spread two fingers to move it away":"Shift-drag or the wheel moves it deeper";return{text:`Press it against the ${a}: ${l}. The arrow will be the force in your hand.`}}return!n.turned&&e.turned&&(n.turned=!0),!n.turned&&r-n.touchedAt<12?{text:e.touch?"Two fingers turn it. A finger beside it turns the view.":"Ctrl-drag turns it. Space lets go. Right-drag turns the view."}:null}var Dr={grasped:1,armed:2,fault:4,paused:8,ended:16,fading:32,heldBack:64,squeezed:128,constrained:256};var _d=64;var ol=16,bA=48,Wu=48;var al=class extends Error{},bn=(n,e)=>{if(!n)throw new al(e)};function w0(n){bn(n.byteLength>=ol,`a message of ${n.byteLength} bytes has no header`);let e=new DataView(n),t=e.getUint8(0),i=e.getUint8(1),s={bits:e.getUint16(2,!0),count:e.getUint32(4,!0),time:e.getFloat64(8,!0)},r={1:wA,2:TA,3:CA,4:EA,5:AA};return bn(r[t],`message type ${t} is not known`),bn(i===1,`layout ${i} of message type ${t} is not known`),r[t](n,e,s)}function ll(n,e,t){bn(n.byteLength===e,`${t} of ${n.byteLength} bytes, ${e} expected`)}function xd(n,e){let t=e;return(i,s)=>{let r=new i(n,t,s);return t+=4*s,r}}function vd({positions:n,triangles:e,patchOfTriangle:t},i,s,r){bn(n.every(Number.isFinite),`${r} with a position that is no number`),bn(e.every(o=>o<i),`${r} with a triangle of a vertex that is not there`),bn(t.every(o=>o<s||o===4294967295),`${r} with a triangle of a patch that is not there`)}function wA(n,e,{count:t}){bn(n.byteLength>=32,`mesh of ${n.byteLength} bytes, 32 at least`);let[i,s,r,o]=[16,20,24,28].map(c=>e.getUint32(c,!0));ll(n,32+12*i+16*s+4*r+8*o,"mesh");let a=xd(n,32),l={kind:"mesh",number:t,positions:a(Float32Array,3*i),triangles:a(Uint32Array,3*s),patchOfTriangle:a(Uint32Array,s),nodeOfPatch:a(Int32Array,r),parents:a(Int32Array,o),levels:a(Int32Array,o)};return vd(l,i,r,"mesh"),bn(l.nodeOfPatch.every(c=>c>=0&&c<o),"mesh with a patch of a node that is not there"),bn(l.parents.every(c=>c>=-1&&c<o),"mesh with a parent that is not there"),bn(l.levels.every(c=>c>=0),"mesh with a negative level"),l}function EA(n,e,{bits:t,count:i}){bn(n.byteLength>=32,`level of ${n.byteLength} bytes, 32 at least`);let[s,r,o]=[16,20,24].map(c=>e.getUint32(c,!0));ll(n,32+12*s+16*r+4*o,"level");let a=xd(n,32),l={kind:"level",number:i,level:t,positions:a(Float32Array,3*s),triangles:a(Uint32Array,3*r),patchOfTriangle:a(Uint32Array,r),nodeOfPatch:a(Int32Array,o)};return bn(t>0,"level 0 comes as a mesh"),vd(l,s,o,"level"),bn(l.nodeOfPatch.every(c=>c>=-1),"level with a patch of no node that could be"),l}function AA(n,e,{count:t}){bn(n.byteLength>=32,`relief of ${n.byteLength} bytes, 32 at least`);let[i,s,r]=[16,20,24].map(l=>e.getUint32(l,!0));ll(n,32+12*i+16*s,"relief");let o=xd(n,32),a={kind:"relief",number:t,patches:r,positions:o(Float32Array,3*i),triangles:o(Uint32Array,3*s),patchOfTriangle:o(Uint32Array,s)};return vd(a,i,r,"relief"),a}function TA(n,e,{bits:t,count:i,time:s}){return bn(t>0,"channels without a column"),bn(Number.isFinite(s),"channels without a time"),ll(n,ol+4*t*i,"channels"),{kind:"channels",columns:t,rows:i,time:s,values:new Float32Array(n,ol,t*i)}}function CA(n,e,{bits:t,count:i,time:s}){bn(n.byteLength>=240,`snapshot of ${n.byteLength} bytes, 240 at least`);let r=e.getUint32(216,!0),o=e.getUint32(236,!0);ll(n,240+Wu*(i+r+o),"snapshot");let a=new Float32Array(n,24,bA),l=f=>[a[f],a[f+1],a[f+2]],c=f=>({position:l(f),quaternion:[a[f+3],a[f+4],a[f+5],a[f+6]]}),u={kind:"snapshot",time:s,bits:t,frame:e.getFloat64(16,!0),object:c(0),ghost:c(7),handle:c(14),grasp:l(21),force:l(24),torque:l(27),contactForce:l(30),contactTorque:l(33),center:l(36),penetration:a[39],stretch:a[40],energy:a[41],modelAge:a[42],modelWeight:a[43],hapticRate:a[44],contactRate:a[45],queryCpu:a[46],metresPerNewton:a[47],contactsFound:e.getUint32(220,!0),contactsDropped:e.getUint32(224,!0),front:e.getUint32(228,!0),fault:e.getUint32(232,!0),contacts:[],clusters:[],rows:[]};bn(a.subarray(0,24).every(Number.isFinite),"snapshot with a pose that is no number");for(let f=0;f<i;f++)u.contacts.push(RA(e,240+Wu*f));for(let f=0;f<r;f++)u.clusters.push(PA(e,240+Wu*(i+f)));for(let f=0;f<o;f++)u.rows.push(IA(e,240+Wu*(i+r+f)));return u}var lr=(n,e,t)=>Array.from({length:t},(i,s)=>n.getFloat32(e+4*s,!0));function RA(n,e){let t=n.getUint32(e+44,!0);return{point:lr(n,e,3),normal:lr(n,e+12,3),depth:n.getFloat32(e+24,!0),bound:n.getFloat32(e+28,!0),body:n.getInt32(e+32,!0),objectNode:n.getInt32(e+36,!0),sceneNode:n.getInt32(e+40,!0),objectLevel:t&255,sceneLevel:t>>8&255,status:t>>16&255,decidedBy:t>>>24}}function PA(n,e){return{point:lr(n,e,3),normal:lr(n,e+12,3),depth:n.getFloat32(e+24,!0),force:lr(n,e+28,3),id:n.getInt32(e+40,!0)}}function IA(n,e){let t=n.getUint32(e+44,!0);return{point:lr(n,e,3),normal:lr(n,e+12,3),gap:n.getFloat32(e+24,!0),force:lr(n,e+28,3),friction:n.getFloat32(e+40,!0),kind:t&3,presses:(t&4)!==0}}function E0(n){let e=null;try{e=JSON.parse(n)}catch{}return bn(e&&typeof e=="object"&&typeof e.type=="string","a text message without a type"),e}function A0(n){let e=new ArrayBuffer(ol+n.length),t=new DataView(e);return t.setUint8(0,33),t.setUint8(1,1),t.setUint32(4,n.length,!0),new Uint8Array(e,ol).set(n),e}var NA=.004,T0=9.9;function C0(){return{position:[0,0,0],quaternion:[0,0,0,1],clutch:!1,pending:[],latest:-1/0}}function yi(n,e){return[n[3]*e[0]+n[0]*e[3]+n[1]*e[2]-n[2]*e[1],n[3]*e[1]-n[0]*e[2]+n[1]*e[3]+n[2]*e[0],n[3]*e[2]+n[0]*e[1]-n[1]*e[0]+n[2]*e[3],n[3]*e[3]-n[0]*e[0]-n[1]*e[1]-n[2]*e[2]]}var Ur=n=>[-n[0],-n[1],-n[2],n[3]];function cl(n,e){let[t,i,s]=yi(yi(n,[...e,0]),Ur(n));return[t,i,s]}function Xu(n,e){let t=Math.sin(.5*e);return[t*n[0],t*n[1],t*n[2],Math.cos(.5*e)]}function qu(n,e,t){let i=cl(Ur(t.quat_xyzw),e);n.position=n.position.map((s,r)=>Math.max(-T0,Math.min(T0,s+i[r]/t.motion_scale)))}var Yu=(n,e,t,i)=>yd(n,Xu(e,t),i);function yd(n,e,t){let i=t.quat_xyzw,s=yi(yi(yi(Ur(i),e),i),n.quaternion),r=Math.hypot(...s);n.quaternion=s.map(o=>o/r)}function DA(n,e,t=-1/0){let i=n[n.length-1],s=n[n.length-2]?.time??t;i&&i.buttons===e.buttons&&i.time-s<NA?n[n.length-1]=e:n.push(e),n.length>_d&&n.splice(0,n.length-_d)}var Sd=n=>({position:[...n.position],quaternion:[...n.quaternion]});function cr(n,e,t=Sd(n)){let i={time:Math.max(e,n.latest),...t,buttons:n.clutch?1:0};DA(n.pending,i,n.sent),n.latest=i.time}function Md(n){let e=n.pending;return n.pending=[],e.length>0&&(n.sent=e[e.length-1].time),e}function R0(n,e,t,i=.7){let s=e.length/3,r=n.length/3,o=new Float64Array(e.length),a=new Float64Array(e.length);for(let d=0;d<s;d++)UA(n,e,d,o,a);let l=new Uint32Array(r+1);for(let d of e)l[d+1]++;for(let d=0;d<r;d++)l[d+1]+=l[d];let c=new Uint32Array(e.length),u=l.slice();for(let d=0;d<e.length;d++)c[u[e[d]]++]=d;let f=[],h=[],p=[],g=new Uint32Array(e.length),y=Math.cos(i);for(let d=0;d<r;d++){let m=c.subarray(l[d],l[d+1]),v=new Map;for(let T of m){let S=3*Math.floor(T/3),C=0,A=0,_=0,w=0;for(let I=0;I<m.length;I++){let k=3*Math.floor(m[I]/3),W=a[S]*a[k]+a[S+1]*a[k+1]+a[S+2]*a[k+2];k!==S&&!(W>y)&&m.length<=31||(w|=1<<(I&31),C+=o[k],A+=o[k+1],_+=o[k+2])}let U=t[Math.floor(T/3)],L=U*2**32+(w>>>0);if(!v.has(L)){v.set(L,f.length/3),p.push(U),f.push(n[3*d],n[3*d+1],n[3*d+2]);let I=Math.hypot(C,A,_)||1;h.push(C/I,A/I,_/I)}g[T]=v.get(L)}}return{positions:Float32Array.from(f),normals:Float32Array.from(h),labels:Float32Array.from(p),index:g}}function UA(n,e,t,i,s){let r=3*e[3*t],o=3*e[3*t+1],a=3*e[3*t+2],l=n[o]-n[r],c=n[o+1]-n[r+1],u=n[o+2]-n[r+2],f=n[a]-n[r],h=n[a+1]-n[r+1],p=n[a+2]-n[r+2],g=[c*p-u*h,u*f-l*p,l*h-c*f],y=Math.hypot(g[0],g[1],g[2]);for(let d=0;d<3;d++)i[3*t+d]=g[d],s[3*t+d]=y>0?g[d]/y:0}function P0(n){let e=new Float64Array(n.length),t=n.reduce((s,r)=>Math.max(s,r),0)+1;for(let s=0;s<n.length;s++){let r=n[s],o=n[s%3===2?s-2:s+1];e[s]=Math.min(r,o)*t+Math.max(r,o)}e.sort();let i=[];for(let s=0;s<e.length;s++)s>0&&e[s]===e[s-1]||i.push(Math.floor(e[s]/t),e[s]%t);return Uint32Array.from(i)}function I0(n){let e=10**Math.floor(Math.log10(n));return e*[5,2,1].find(t=>t*e<=n*(1+1e-9))}function bd(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let s=0;s<n.length;s++){let r=s%3;n[s]<e[r]&&(e[r]=n[s]),n[s]>t[r]&&(t[r]=n[s])}let i=e.map((s,r)=>.5*(s+t[r]));return{min:e,max:t,center:i,radius:.5*Math.hypot(...e.map((s,r)=>t[r]-s))}}function L0(n){let e=new ln,t=new be(n,new Xi({colorWrite:!1,transparent:!0}));t.onBeforeRender=s=>s.clearDepth();let i=new be(n,new ai({transparent:!0,depthWrite:!1,uniforms:{tone:{value:new Ye}},vertexShader:`varying vec3 facing; varying vec3 toEye;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  facing = normalize(normalMatrix * normal);
  toEye = -seen.xyz;
  gl_Position = projectionMatrix * seen;
}`,fragmentShader:`varying vec3 facing; varying vec3 toEye; uniform vec3 tone;
void main() {
  float rim = 1.0 - abs(dot(normalize(facing), normalize(toEye)));
  gl_FragColor = vec4(tone, 0.10 + 0.55 * rim * rim * rim);
  #include <colorspace_fragment>
}`}));return t.renderOrder=10,i.renderOrder=11,e.add(t,i),e.visible=!1,{group:e,hidden:t,glass:i}}function N0(n,e){n.hidden.geometry=n.glass.geometry=e}function D0({object:n,ghost:e},t){let i=Math.hypot(...n.position.map((o,a)=>o-e.position[a])),s=new At(...n.quaternion),r=new At(...e.quaternion);return i/t+s.angleTo(r)}var U0=n=>new Ye(n).toArray(),Fr={from:[2.3,-1.5,3.6],colour:16774372,tone:U0(16774372),strength:2.6},Or={from:[-2.2,2.2,1.2],colour:13624319,tone:U0(13624319),strength:.9};function F0(n){let e=new Ba(16777215,9077624,1.5);e.position.set(0,0,1);let t=new Po(Fr.colour,Fr.strength);t.position.set(...Fr.from),t.castShadow=!0,t.shadow.mapSize.setScalar(1536),Object.assign(t.shadow.camera,{left:-1.5,right:1.5,top:1.5,bottom:-1.5,near:.5,far:9}),t.shadow.radius=4,t.shadow.bias=-6e-4,t.shadow.normalBias=.006;let i=new Po(Or.colour,Or.strength);i.position.set(...Or.from);let s=new Ga(16777215,.18);return n.add(e,t,i,s),{sky:e,key:t,rim:i,fill:s}}function O0(n){let e=new be(new Ls(12,12),new Da({opacity:.2}));return e.receiveShadow=!0,e.renderOrder=-1,n.add(e),e}var B0="thigma-theme";function $u(){let n=document.documentElement.dataset.theme;return n||(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light")}function k0(n){let e=null;try{e=localStorage.getItem(B0)}catch{}return(e==="light"||e==="dark")&&(document.documentElement.dataset.theme=e),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>n()),function(){let i=$u()==="dark"?"light":"dark";document.documentElement.dataset.theme=i;try{localStorage.setItem(B0,i)}catch{}n()}}function Rt(n){return getComputedStyle(document.documentElement).getPropertyValue(`--${n}`).trim()}var Fs=["#0a8f83","#23ab6a","#7cc542","#bdd334","#e6d32e","#f5a32b","#ea7430","#d64a45"];function Br(n){return Fs[Math.max(0,Math.min(Fs.length-1,n))]}var Ed=512,V0=16,fl=new B(0,0,1);function ur(n={}){return new Fa(n)}function kr(n={}){return new Xi({transparent:!0,opacity:.42,depthTest:!1,depthWrite:!1,...n})}function H0(){let n=new ln,e=new Wt(.5,.5,1,20).rotateX(Math.PI/2).translate(0,0,.5),t=new Is(1.35,3.6,28).rotateX(Math.PI/2).translate(0,0,1.8),i=[];for(let s of[ur(),kr()]){let r=new be(e,s),o=new be(t,s);r.renderOrder=o.renderOrder=s.depthTest?0:20,i.push({shaft:r,head:o,material:s}),n.add(r,o)}return n.visible=!1,{group:n,parts:i}}function W0(n,e,t,i){let s=t.length();if(n.group.visible=s>.2*i,!n.group.visible)return;n.group.position.copy(e),n.group.quaternion.setFromUnitVectors(fl,t.clone().divideScalar(s));let r=Math.min(i,s/3.6);for(let{shaft:o,head:a}of n.parts)o.scale.set(r,r,Math.max(1e-6*i,s-3.4*r)),a.scale.setScalar(r),a.position.set(0,0,s-3.6*r)}function X0(n,e){for(let{material:t}of n.parts)t.color.set(e)}var ul=72,Os=10,z0=.055;function q0(){let n=new ln,e=FA(),t=new Is(.15,.38,24),i=[];for(let s of[ur(),kr()]){let r=new be(e,s),o=new be(t,s);r.renderOrder=o.renderOrder=s.depthTest?0:20,i.push({ring:r,head:o,material:s}),n.add(r,o)}return n.visible=!1,{group:n,parts:i,ring:e}}function FA(){let n=[],e=[],t=[];for(let s=0;s<=ul;s++){let r=2*Math.PI*s/ul;for(let o=0;o<Os;o++){let a=2*Math.PI*o/Os,l=Math.cos(a),c=Math.sin(a);e.push(l*Math.cos(r),l*Math.sin(r),c);let u=1+z0*l;n.push(u*Math.cos(r),u*Math.sin(r),z0*c);let f=(o+1)%Os;if(s<ul){let h=s*Os+o,p=s*Os+f;t.push(h,p,h+Os,p,p+Os,h+Os)}}}let i=new mn;return i.setAttribute("position",new dn(Float32Array.from(n),3)),i.setAttribute("normal",new dn(Float32Array.from(e),3)),i.setIndex(t),i}function Y0(n,e,t,i,s){if(n.group.visible=i>.01&&t.lengthSq()>0,!n.group.visible)return;n.group.position.copy(e),n.group.quaternion.setFromUnitVectors(fl,t.clone().normalize()),n.group.scale.setScalar(s);let r=Math.max(1,Math.round(300/360*ul*Math.min(1,i)));n.ring.setDrawRange(0,r*Os*6);let o=2*Math.PI*r/ul;for(let{head:a}of n.parts)a.position.set(Math.cos(o),Math.sin(o),0),a.rotation.set(0,0,o),a.scale.setScalar(Math.min(1,.25+4*i))}function $0(n,e){for(let{material:t}of n.parts)t.color.set(e)}function Zu(n,e,t,i,s){let r=new Ra(e,t,i);return r.frustumCulled=!1,r.renderOrder=s,r.count=0,r.setColorAt(0,new Ye),n.add(r),r}function Z0(){let n=new ln,e=new hs(1,12,8),t=new Wt(.22,.22,1,8).rotateX(Math.PI/2).translate(0,0,.5),i=new qi(1,.12,8,40),s=(...o)=>Zu(n,...o),r={group:n,dots:[],needles:[],rings:[]};for(let[o,a]of[[ur(),1],[kr({opacity:.45}),21]])r.dots.push(s(e,o,Ed,a)),r.needles.push(s(t,o,Ed,a));for(let[o,a]of[[ur(),1],[kr({opacity:.55}),22]])r.rings.push(s(i,o,V0,a));return r}var G0=new vt,Ad=new At,Td=new B,Cd=new B,Rd=new Ye;function Pd(n,e,t,i,s){let r=Math.min(Ed,e.length);for(let a=0;a<r;a++){let{point:l,normal:c,level:u}=e[a];Td.set(...l),Ad.setFromUnitVectors(fl,Cd.set(...c).normalize()),Rd.set(Br(u)),wd(n.dots,a,i,i),wd(n.needles,a,i,5.5*i)}hl(n.dots,r),hl(n.needles,r);let o=Math.min(V0,t.length);for(let a=0;a<o;a++){Td.set(...t[a].point),Ad.setFromUnitVectors(fl,Cd.set(...t[a].normal).normalize()),Rd.set(s);let l=i*(2.6+2.4*Math.sqrt(Math.max(0,Math.min(1,t[a].share))));wd(n.rings,a,l,l)}hl(n.rings,o)}function wd(n,e,t,i){G0.compose(Td,Ad,Cd.set(t,t,i));for(let s of n)s.setMatrixAt(e,G0),s.setColorAt(e,Rd)}function hl(n,e){for(let t of n)t.count=e,t.instanceMatrix.needsUpdate=!0,t.instanceColor&&(t.instanceColor.needsUpdate=!0)}function J0(){let n=ur(),e=kr({opacity:.5}),t=new ln,i=new Wt(1,1,1,10).rotateX(Math.PI/2).translate(0,0,.5),s=new hs(1,16,12),r=[],o=[];for(let a of[n,e]){let l=new be(i,a),c=new be(s,a);l.renderOrder=c.renderOrder=a.depthTest?0:23,r.push(l),o.push(c),t.add(l,c)}return{group:t,rods:r,knobs:o,materials:[n,e]}}function j0(n,e,t,i){let s=t.clone().sub(e),r=s.length();n.group.position.copy(e),r>0&&n.group.quaternion.setFromUnitVectors(fl,s.divideScalar(r));for(let o of n.rods)o.scale.set(i,i,Math.max(r,1e-9*i));for(let o of n.knobs)o.position.set(0,0,r),o.scale.setScalar(2.6*i)}function K0(n,e){for(let t of n.materials)t.color.set(e)}var Ld=64,Id=new B(0,0,1);function t_(){let n=new ln,e={planes:new Wt(1,1,.06,28).rotateX(Math.PI/2),points:new hs(.36,12,8),forces:new Wt(.16,.16,1,8).rotateX(Math.PI/2).translate(0,0,.5),heads:new Is(.42,1,16).rotateX(Math.PI/2).translate(0,0,.5),cones:new Is(1,1,28,1,!0).translate(0,-.5,0).rotateX(-Math.PI/2)},t={group:n};for(let[i,s]of Object.entries(e)){let r=i==="cones"||i==="planes",o=r?ur({transparent:!0,opacity:i==="cones"?.34:.72,depthWrite:!1,side:2}):ur(),a=kr({opacity:r?.16:.5,side:r?2:0});t[i]=[Zu(n,s,o,Ld,r?3:2),Zu(n,s,a,Ld,22)]}return t}var Q0=new vt,Ju=new At,dl=new B,ju=new B,OA=new B,e_=new Ye;function Nd(n,e,{size:t,longest:i},s){let r=e.slice(0,Ld),o=Math.max(1e-30,...r.map(({force:c})=>Math.hypot(...c))),a={planes:0,points:0,forces:0,heads:0,cones:0},l=(c,u,f)=>{Q0.compose(dl,Ju,OA.set(u,u,f));for(let h of n[c])h.setMatrixAt(a[c],Q0),h.setColorAt(a[c],e_);a[c]+=1};for(let{point:c,normal:u,gap:f,force:h,friction:p,kind:g,presses:y}of r){e_.set(y?s.press:s.near);let d=c.map((C,A)=>C+f*u[A]),m=y?t:.62*t;if(Ju.setFromUnitVectors(Id,ju.set(...u).normalize()),dl.set(...g===1?d:c),l("points",m,m),dl.set(...g===1?c:d),l(g===2?"points":"planes",m,m),!y)continue;dl.set(...c),p>0&&(Ju.setFromUnitVectors(Id,ju.set(...u).multiplyScalar(-1).normalize()),l("cones",.8*i*p,.8*i));let v=Math.hypot(...h);if(!(v>0))continue;Ju.setFromUnitVectors(Id,ju.set(...h).divideScalar(v));let T=i*(.25+.75*v/o),S=Math.min(1.1*t,.5*T);l("forces",t,T-S),dl.addScaledVector(ju,T-S),l("heads",t,S)}for(let[c,u]of Object.entries(a))hl(n[c],u)}function i_(n,e){let{positions:t,triangles:i,patchOfTriangle:s}=n,r=t.length/3,o=new Uint32Array(r),a=new Map,l=(y,d)=>Math.floor(t[3*y+d]/e)+1e5;for(let y=0;y<r;y++){let d=(l(y,0)*2e5+l(y,1))*2e5+l(y,2),m=a.get(d);m===void 0&&a.set(d,m=a.size),o[y]=m}let c=new Float32Array(3*a.size),u=new Uint32Array(a.size),f=new Float64Array(3*a.size);for(let y=0;y<r;y++){u[o[y]]+=1;for(let d=0;d<3;d++)f[3*o[y]+d]+=t[3*y+d]}for(let y=0;y<c.length;y++)c[y]=f[y]/u[Math.floor(y/3)];let h=0;for(let y=0;y<r;y++){let d=0;for(let m=0;m<3;m++)d+=(t[3*y+m]-c[3*o[y]+m])**2;h=Math.max(h,d)}let p=[],g=[];for(let y=0;y<i.length;y+=3){let[d,m,v]=[o[i[y]],o[i[y+1]],o[i[y+2]]];d===m||m===v||v===d||(p.push(d,m,v),g.push(s[y/3]))}return{mesh:{...n,positions:c,triangles:Uint32Array.from(p),patchOfTriangle:Uint32Array.from(g)},deviation:Math.sqrt(h)}}var n_=[.064,.032,.016,.008],BA=.6,kA=4e3;function s_(n,e,t,i,s){if(e<kA)return 0;for(let r=0;r<n_.length;r++){let o=-1-r,a=n_[r]*t;if(!n.has(o)&&BA*a>i)continue;if((n.get(o)??s(o,a))<=i)return o}return 0}function r_(n,e,t){let i=0;return(n??[]).forEach(({free:s,triangles:r,deviation:o},a)=>{a>0&&!s&&r>0&&Number.isFinite(o)&&o!==null&&o<=t*e&&r<n[i].triangles&&(i=a)}),i}function o_(n,e){for(let t=n;t>0;t--)if(e(t))return t;return 0}function a_(n,e,t){let i=new Float64Array(3*t).fill(1/0),s=new Float64Array(3*t).fill(-1/0);for(let o=0;o<e.length;o++)for(let a=0;e[o]>=0&&a<3;a++){let l=3*e[o]+a,c=n[3*o+a];c<i[l]&&(i[l]=c),c>s[l]&&(s[l]=c)}let r=new Float32Array(4*t).fill(-1);for(let o=0;o<t;o++){if(!(i[3*o]<=s[3*o]))continue;let a=0;for(let l=0;l<3;l++)r[4*o+l]=.5*(i[3*o+l]+s[3*o+l]),a+=(s[3*o+l]-i[3*o+l])**2;r[4*o+3]=.5*Math.sqrt(a)}return r}function l_(n,e,t,i){i.fill(0);for(let{point:[s,r,o]}of e)for(let a=0;a<i.length;a++){let l=n[4*a+3]+t;if(n[4*a+3]<0)continue;let c=n[4*a]-s,u=n[4*a+1]-r,f=n[4*a+2]-o;c*c+u*u+f*f<l*l&&(i[a]=255)}}function c_(n,e){let t=e.length,i=new Uint32Array(t);for(let h of n)i[h]++;let s=GA(e),r=i.slice();for(let h=t-1;h>=0;h--){let p=s[h];e[p]>=0&&(r[e[p]]+=r[p])}let o=new Uint32Array(t),a=new Uint32Array(t),l=new Uint32Array(t),c=0;for(let h of s){let p=e[h];o[h]=p<0?c:l[p],a[h]=o[h]+r[h],p<0?c=a[h]:l[p]=a[h],l[h]=o[h]+i[h]}let u=new Uint32Array(n.length),f=o.slice();for(let h=0;h<n.length;h++)u[f[n[h]]++]=h;return{order:u,begin:o,end:a}}function GA(n){let e=n.map(()=>0);for(let r of n)r>=0&&e[r]++;let t=new Uint32Array(n.length),i=n.length,s=[];for(let r=0;r<n.length;r++)e[r]===0&&s.push(r);for(;s.length>0;){let r=s.pop();t[--i]=r,n[r]>=0&&--e[n[r]]===0&&s.push(n[r])}if(i!==0)throw new RangeError("the hierarchy runs in a circle");return t}function u_(n,e,t){t.fill(0);for(let{node:i,level:s}of e)if(!(i<0||i>=n.begin.length))for(let r=n.begin[i];r<n.end[i];r++){let o=n.order[r];(t[o]===0||t[o]>s+1)&&(t[o]=Math.min(255,s+1))}}var h_=(n,e)=>n.patchOfTriangle[e]===4294967295?-1:n.patchOfTriangle[e];function f_(n,e,t,i){return Int32Array.from(n,s=>{let r=s;for(;e[r]>=0&&t[e[r]]<=i;)r=e[r];return r})}function d_(n,e,t,i){i.fill(0);let s=t.filter(({node:r})=>r>=0&&r<n.begin.length);for(let r=0;r<e.length;r++){let o=e[r];if(!(o<0||o>=n.begin.length))for(let{node:a,level:l}of s)n.begin[a]<=n.begin[o]&&n.end[o]<=n.end[a]&&(i[r]===0||i[r]>l+1)&&(i[r]=Math.min(255,l+1))}}function p_(n){let e=n*.61803398875%1,t=[.62,.5,.72][n%3],i=.55,s=r=>{let o=(r+e*12)%12;return Math.round(255*(t-i*Math.min(t,1-t)*Math.max(-1,Math.min(o-3,9-o,1))))};return[s(0),s(8),s(4)]}var Go=24,hr=1024;function g_(n){return{patchLevels:{value:n},spotCount:{value:0},spotRadius:{value:1},spots:{value:Array.from({length:Go},()=>new Ht)},levelColours:{value:Fs.map((e,t)=>new Ye(Br(t)))},onlyActive:{value:0},patchTints:{value:null},tinted:{value:0}}}var __=`attribute float patchNumber;
uniform sampler2D patchLevels;
uniform sampler2D patchTints;
uniform float tinted;
varying vec3 meshPoint;
flat varying vec2 patchState;
flat varying vec4 patchTint;`,x_=`meshPoint = position;
patchState = vec2(0.0);
patchTint = vec4(0.0);
if (patchNumber >= 0.0) {
  int patchIndex = int(patchNumber + 0.5);
  ivec2 cell = ivec2(patchIndex % ${hr}, patchIndex / ${hr});
  patchState = floor(texelFetch(patchLevels, cell, 0).rg * 255.0 + 0.5);
  if (tinted > 0.5) patchTint = vec4(texelFetch(patchTints, cell, 0).rgb, 1.0);
}`,v_=`varying vec3 meshPoint;
flat varying vec2 patchState;
flat varying vec4 patchTint;
uniform int spotCount;
uniform float spotRadius;
uniform float onlyActive;
uniform vec4 spots[${Go}];
uniform vec3 levelColours[${Fs.length}];
/// The colour of a point of the surface: its own, of its patch, or of a contact nearby.
vec3 markedColour(vec3 base) {
  int level = int(patchState.x) - 1;
  float share = level >= 0 ? 0.92 : 0.0;
  if (level < 0 && patchState.y > 0.5) {
    float nearest = 1.0;
    for (int k = 0; k < ${Go}; k++) {
      if (k >= spotCount) break;
      float d = distance(meshPoint, spots[k].xyz) / spotRadius;
      if (d < nearest) { nearest = d; level = int(spots[k].w); }
    }
    share = 0.85 * (1.0 - smoothstep(0.3, 1.0, nearest));
  }
  if (onlyActive > 0.5 && share < 0.02) discard;
  vec3 tone = levelColours[clamp(level, 0, ${Fs.length-1})];
  if (patchTint.a > 0.5) return mix(patchTint.rgb, tone, 0.75 * step(0.9, share));
  return mix(base, tone, share);
}`;function y_(n){let e=new Ua({roughness:.62,metalness:0});return e.onBeforeCompile=t=>{Object.assign(t.uniforms,n),t.vertexShader=t.vertexShader.replace("#include <common>",`#include <common>
${__}`).replace("#include <begin_vertex>",`#include <begin_vertex>
${x_}`),t.fragmentShader=t.fragmentShader.replace("#include <common>",`#include <common>
${v_}`).replace("#include <color_fragment>",`#include <color_fragment>
diffuseColor.rgb = markedColour(diffuseColor.rgb);`)},e}var Dd=n=>`vec3(${n.map(e=>e.toFixed(5)).join(", ")})`,m_=({from:n})=>Dd(new B(...n).normalize().toArray());function S_(n,e,t){return new ai({uniforms:{...n,base:e,sky:t},vertexShader:`${__}
varying vec3 facing;
void main() {
  ${x_}
  facing = mat3(modelMatrix) * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,fragmentShader:`${v_}
uniform vec3 base;
uniform float sky;
varying vec3 facing;
void main() {
  vec3 n = normalize(facing);
  vec3 light = mix(vec3(0.25, 0.22, 0.19), vec3(1.0), 0.5 + 0.5 * n.z) * sky + ${Fr.strength.toFixed(3)} * ${Dd(Fr.tone)} * max(0.0, dot(n, ${m_(Fr)}))
    + ${Or.strength.toFixed(3)} * ${Dd(Or.tone)} * max(0.0, dot(n, ${m_(Or)})) + 0.28;
  vec3 lit = markedColour(base) * light * 0.31831;
  float peak = max(lit.r, max(lit.g, lit.b)), over = peak - 0.76; // bright ones flatten out, as by NeutralToneMapping
  if (over > 0.0) lit *= (1.0 - 0.0576 / (over + 0.24)) / peak;
  gl_FragColor = vec4(lit, 1.0);
  #include <colorspace_fragment>
}`})}function pl(n,e=c_(n.nodeOfPatch,n.parents)){let t=n.triangles.length/3,i=n.nodeOfPatch.length,s=Float32Array.from({length:t},(d,m)=>h_(n,m)),r=R0(n.positions,n.triangles,s),o=new mn;o.setAttribute("position",new dn(r.positions,3)),o.setAttribute("normal",new dn(r.normals,3)),o.setAttribute("patchNumber",new dn(r.labels,1)),o.setIndex(new dn(r.index,1));let a=new Uint8Array(2*hr*M_(n)),l=b_(a,Zi),c=g_(l),u={value:new Ye},f={value:1},h={rich:y_(c),plain:S_(c,u,f)};h.rich.color=u.value;let p=new be(o,h.rich);p.castShadow=p.receiveShadow=!0;let g=new Pa(new mn,new tr({transparent:!0,opacity:.16}));g.visible=!1;let y=new ln;return y.add(p,g),{group:y,solid:p,lines:g,uniforms:c,geometry:o,mesh:n,ranges:e,materials:h,colour:u,sky:f,state:a,patchLevels:l,bytes:new Uint8Array(i),near:new Uint8Array(i),balls:a_(r.positions,r.labels,i)}}var M_=n=>Math.max(1,Math.ceil(n.nodeOfPatch.length/hr)),VA=new Map([[Fo,1],[Zi,2],[li,4]]);function b_(n,e){let t=new wr(n,hr,n.length/(hr*VA.get(e)),e,Wn);return t.unpackAlignment=1,t.needsUpdate=!0,t}function w_(n,e){let{uniforms:t,mesh:i}=n;if(t.tinted.value=e===null?0:1,e===null||n.tintedAt===e)return;let s=i.parents?f_(i.nodeOfPatch,i.parents,i.levels,e):i.nodeOfPatch,r=new Uint8Array(4*hr*M_(i));s.forEach((o,a)=>r.set([...p_(Math.max(0,o)),255],4*a)),t.patchTints.value?.dispose(),t.patchTints.value=b_(r,li),n.tintedAt=e}function Ku(n,{base:e,line:t,sky:i}){n.colour.value.set(e),n.sky.value=i,n.lines.material.color.set(t)}function Qu(n,e){n.solid.material=e?n.materials.rich:n.materials.plain}function E_(n,e,t){n.solid.visible=e!=="none",n.uniforms.onlyActive.value=e==="active"?1:0,n.lines.visible=t>0,n.lines.material.opacity=t,t>0&&!n.lines.geometry.index&&(n.lines.geometry.setAttribute("position",new dn(n.mesh.positions,3)),n.lines.geometry.setIndex(new dn(P0(n.mesh.triangles),1)))}function A_(n,e,t,i,s){let{bytes:r,near:o,balls:a,state:l,uniforms:c}=n;n.mesh.parents?u_(n.ranges,e,r):d_(n.ranges,n.mesh.nodeOfPatch,e,r);let u=t.slice(0,Go);l_(a,u,i,o);for(let f=0;f<r.length;f++)a[4*f+3]>s&&(r[f]=0),l[2*f]=r[f],l[2*f+1]=o[f];n.patchLevels.needsUpdate=!0,c.spotCount.value=u.length,c.spotRadius.value=i,u.forEach(({point:f,level:h},p)=>c.spots.value[p].set(...f,h))}function T_(n,e,t=Go){let i=[];for(let s of n){if(i.length===t)break;i.some(o=>o.level===s.level&&HA(o.point,s.point)<e)||i.push(s)}return i}var HA=(n,e)=>Math.hypot(n[0]-e[0],n[1]-e[1],n[2]-e[2]);function C_(n){n.geometry.dispose(),n.patchLevels.dispose(),n.uniforms.patchTints.value?.dispose(),n.lines.geometry.dispose();for(let e of Object.values(n.materials))e.dispose();n.lines.material.dispose()}function Ud(n,e){let t=pl(n);return{group:t.group,geometry:t.geometry,finest:t,about:e,levels:new Map,made:new Map,relief:null,browsed:null,wireframe:!1,drawn:0,rich:!0,colours:null}}function R_(n,e){return e>0&&!n.levels.has(e)&&eh(n,e)}function eh({about:n},e){let t=n.level_list?.[e];return!!t&&!t.free&&t.triangles>0}function P_(n,e){n.levels.has(e.level)||I_(n,e.level,pl(e,n.finest.ranges))}function I_(n,e,t){n.levels.set(e,t),n.group.add(t.group),n.colours&&Ku(t,n.colours),Qu(t,n.rich),nh(n)}function L_(n,e){let{nodeOfPatch:t,parents:i,levels:s}=n.finest.mesh;n.relief||e.patches!==t.length||(n.relief=pl({...e,nodeOfPatch:t,parents:i,levels:s},n.finest.ranges),n.group.add(n.relief.group),n.colours&&Ku(n.relief,n.colours),Qu(n.relief,n.rich),nh(n))}function Fd(n,e){n.colours=e;for(let t of ml(n))Ku(t,e)}function Od(n,e){n.rich=e;for(let t of ml(n))Qu(t,e)}var ml=n=>[n.finest,...n.levels.values(),...n.relief?[n.relief]:[]],N_=(n,e)=>n.levels.get(e)??n.finest;function th(n,{wireframe:e=n.wireframe,browsed:t=n.browsed}){Object.assign(n,{wireframe:e,browsed:t}),nh(n)}function Bd(n,e,t){let{level_list:i,radius:s,triangles:r}=n.about;return i?.some((o,a)=>a>0&&eh(n,a))?r_(i,e,t):s_(n.made,r,s,t*e,(o,a)=>{let{mesh:l,deviation:c}=i_(n.finest.mesh,a);return I_(n,o,pl(l,n.finest.ranges)),n.made.set(o,c),c})}function D_(n,e){let t=e<0?e:o_(e,i=>n.levels.has(i));return t===n.drawn?!1:(n.drawn=t,nh(n),!0)}var kd=(n,e=n.drawn)=>N_(n,e),U_=n=>n.drawn===0&&n.relief?n.relief:kd(n),WA=(n,e)=>e!==n.relief&&![...n.made.keys()].some(t=>n.levels.get(t)===e);function nh(n){let{browsed:e,wireframe:t}=n,i=e===null?t?null:U_(n):N_(n,e);for(let s of ml(n)){let r=e!==null&&s===i;w_(s,r?e:null);let o=s===i?"whole":i===null&&WA(n,s)?"active":"none";E_(s,o,r?.3:t&&e===null&&s===n.finest?.16:0)}}function zd(n,e,t){let i=.03*t,s=.075*t,r=a=>n.levels.get(a),o=n.browsed===null&&!n.wireframe;for(let a of ml(n)){let l=({level:u})=>o?a===U_(n):a===n.finest?!r(u)||n.browsed!==null:a===r(u),c=e.filter(l);A_(a,c,T_(c,i),s,o?2*s:1/0)}}function F_(n){for(let e of ml(n))C_(e)}var gl=[{pixels:2,shadows:!0,rich:!0,off:0},{pixels:1,shadows:!0,rich:!0,off:0},{pixels:1,shadows:!1,rich:!0,off:.5},{pixels:1,shadows:!1,rich:!1,off:.5},{pixels:1,shadows:!1,rich:!1,off:1},{pixels:1,shadows:!1,rich:!1,off:2},{pixels:1,shadows:!1,rich:!1,off:4},{pixels:1,shadows:!1,rich:!1,off:6}],k_=3,XA=1/15,z_=.045,qA=.012,O_=2,YA=3,$A=60;function G_({step:n=0,fixed:e=!1}={}){return{step:n,fixed:e,seen:0,mean:0,patience:$A,climbed:!1}}function V_(n,e){if(n.seen+=1,n.fixed||n.seen<=O_)return!1;let t=n.seen-O_;return n.mean+=(e-n.mean)/Math.min(t,8),t>=YA&&n.mean>z_&&n.step<gl.length-1?(n.climbed&&(n.patience*=4),B_(n,1),!0):t>=n.patience&&n.mean<qA&&n.step>0?(B_(n,-1),!0):!1}function B_(n,e){Object.assign(n,{step:n.step+e,seen:0,mean:0,climbed:e<0})}function H_(n,e){return!e&&n<z_?0:Math.max(.25*n,Math.min(n,XA-n-.01))}var Gd=1.6;function ZA(){let n=document.createElement("canvas").getContext("webgl2"),e=n?.getExtension("WEBGL_debug_renderer_info"),t=e?n.getParameter(e.UNMASKED_RENDERER_WEBGL):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t)}function W_(n,e=null){let t=e==="plain"||e!=="full"&&ZA(),i=new Ou({canvas:n,antialias:!t,alpha:!0,powerPreference:"high-performance"});i.outputColorSpace=Qn,i.toneMapping=Ha,i.shadowMap.enabled=!0,i.shadowMap.type=Ar,i.shadowMap.autoUpdate=!1;let s=new Ea,r=new ln;s.add(r);let o={canvas:n,renderer:i,scene:s,root:r,view:a0(),plain:t,lights:F0(s),ground:O0(s),radius:1,size:1,object:null,statics:[],ghost:null,force:H0(),twist:q0(),marks:Z0(),rows:t_(),spring:J0(),dirty:!0,options:{wireframe:!1,ghost:!0,contacts:!0,forces:!0,names:!0},editing:!1,start:null,wants:()=>{},wanted:new Set,last:null,moved:!0,resized:!0,fence:null,begun:0,rested:0,pace:G_({step:t?k_:0,fixed:e==="full"})};return r.add(o.force.group,o.twist.group,o.marks.group,o.rows.group,o.spring.group),o.spring.group.visible=!1,o}function X_(n,e,t,i=!1){let s=i?n.last:null;for(let r of Yn(n))n.root.remove(r.group),F_(r);n.ghost&&n.root.remove(n.ghost.group),n.last=null,n.start={position:e.start.position,quaternion:e.start.quat_xyzw},q_(n),n.object=Ud(t.get(e.object.mesh),e.object),n.statics=e.statics.map(r=>{let o=Ud(t.get(r.mesh),r);return _l(o.group,{position:r.position,quaternion:r.quat_xyzw}),o});for(let r of Yn(n))th(r,{wireframe:n.options.wireframe}),Od(r,gl[n.pace.step].rich);n.ghost=L0(n.object.geometry),_l(n.object.group,n.start),n.root.add(n.object.group,...n.statics.map(r=>r.group),n.ghost.group),n.size=e.object.radius,n.wanted.clear(),i||QA(n),n.moved=!0,sh(n),s&&xl(n,s)}function q_(n){for(let{group:e}of[n.force,n.twist,n.spring])e.visible=!1;Pd(n.marks,[],[],1,Rt("ring")),Nd(n.rows,[],{size:1,longest:1},{near:Rt("contact"),press:Rt("press")})}function Y_(n,e){if(n.editing!==e&&(n.editing=e,!!n.object)){if(!e&&n.last){xl(n,n.last);return}q_(n),n.ghost.group.visible=!1;for(let t of Yn(n))zd(t,[],n.size);_l(n.object.group,n.start),n.dirty=n.moved=!0}}var Yn=n=>n.object?[n.object,...n.statics]:[];function $_(n,e){for(let t of Yn(n))t.about.mesh===e.number&&P_(t,e);n.last&&vl(n,n.last),n.dirty=n.moved=!0}function Z_(n,e){for(let t of Yn(n))t.about.mesh===e.number&&L_(t,e);n.last&&vl(n,n.last),n.dirty=n.moved=!0}function J_(n,e,t){th(e,{browsed:t}),t!==null&&ih(n,e,t),n.last&&vl(n,n.last),n.dirty=n.moved=!0}var JA=3,jA=1e3;async function ih(n,e,t){let i=`${e.about.mesh} ${t}`,{wanted:s}=n;if(!R_(e,t)||s.has(i))return;s.add(i),(await n.wants(e.about.mesh,t)).ok||setTimeout(()=>s.delete(i),jA)}function KA(n){let{off:e}=gl[n.pace.step],t=new B,i=!1;for(let s of Yn(n)){let{center:r,radius:o,relief:a}=s.about;n.root.localToWorld(t.set(...r).applyQuaternion(s.group.quaternion).add(s.group.position));let l=Math.max(n.view.camera.near,sl(n.view,t)-o/n.radius),c=il(n.view,l,n.canvas.clientHeight)*n.radius,u=Bd(s,c,e-(a??0)/c);if(ih(n,s,u),i=D_(s,u)||i,s!==n.object)continue;let f=Bd(s,c,JA*e);ih(n,s,f),N0(n.ghost,kd(s,f).geometry)}i&&n.last&&vl(n,n.last)}function _l(n,e){n.position.fromArray(e.position),n.quaternion.fromArray(e.quaternion)}function QA(n){let e=[];for(let{group:i,geometry:s}of[n.object,...n.statics]){let r=bd(s.attributes.position.array);i.updateMatrix();for(let o=0;o<8;o++){let a=[0,1,2].map(l=>o&1<<l?r.max[l]:r.min[l]);e.push(...new B(...a).applyMatrix4(i.matrix).toArray())}}let t=bd(e);n.radius=t.radius>0?t.radius:1,n.root.scale.setScalar(1/n.radius),n.root.position.fromArray(t.center).multiplyScalar(-1/n.radius),n.ground.position.z=(t.min[2]-t.center[2])/n.radius-.012,n.root.updateMatrixWorld()}function sh(n){let e=Number(Rt("sky"));if(n.object){Fd(n.object,{base:Rt("held"),line:Rt("held-line"),sky:e});for(let t of n.statics)Fd(t,{base:Rt("fixed"),line:Rt("fixed-line"),sky:e});n.ghost.glass.material.uniforms.tone.value.set(Rt("ghost"))}X0(n.force,Rt("force")),$0(n.twist,Rt("torque")),K0(n.spring,Rt("hand")),n.ground.material.opacity=Number(Rt("shadow")),n.lights.sky.intensity=e,n.dirty=!0}function xl(n,e){if(!n.object||(n.last=e,n.editing))return;_l(n.object.group,e.object),_l(n.ghost.group,e.ghost);let t=(e.bits&1)!==0,i=new B(...e.grasp),s=new B(...e.handle.position);n.ghost.group.visible=n.options.ghost&&t&&D0(e,n.size)>.004,n.spring.group.visible=n.options.ghost&&t,j0(n.spring,i,s,.012*n.size),eT(n,e,i),vl(n,e),n.dirty=n.moved=!0}function eT(n,e,t){if(!n.options.forces){n.force.group.visible=n.twist.group.visible=!1;return}let i=e.metresPerNewton>0?e.metresPerNewton:.5*n.size,s=new B(...e.force).multiplyScalar(Gd*i);s.clampLength(0,4*n.size),W0(n.force,t,s,.045*n.size);let r=new B(...e.torque),o=.5*n.size*n.size/i;Y0(n.twist,t,r,r.length()/o,.42*n.size)}function vl(n,e){if(n.editing)return;let t=(e.bits&Dr.constrained)!==0,i=n.options.contacts&&!t?e.contacts:[];Nd(n.rows,n.options.contacts?e.rows:[],{size:.045*n.size,longest:.34*n.size},{near:Rt("contact"),press:Rt("press")});let s=Math.max(1e-30,...e.clusters.map(a=>Math.hypot(...a.force)));Pd(n.marks,i.map(a=>({point:a.point,normal:a.normal,level:a.objectLevel})),n.options.contacts?e.clusters.map(a=>({point:a.point,normal:a.normal,share:Math.hypot(...a.force)/s})):[],.011*n.size,Rt("ring"));let r=(a,l)=>{if(zd(a,l.map(({point:c,node:u,level:f})=>({point:tT(a.group,c),node:u,level:f})),n.size),a.wireframe)for(let{level:c}of l)ih(n,a,c)},o=t&&n.object.about.levels<=1?[]:e.contacts;r(n.object,o.map(a=>({point:a.point,node:a.objectNode,level:a.objectLevel}))),n.statics.forEach((a,l)=>r(a,o.filter(c=>c.body===l).map(c=>({point:c.point,node:c.sceneNode,level:c.sceneLevel}))))}function tT(n,e){return new B(...e).sub(n.position).applyQuaternion(n.quaternion.clone().conjugate()).toArray()}function j_(n,e){Object.assign(n.options,e);for(let t of Yn(n))th(t,{wireframe:n.options.wireframe});n.last&&xl(n,n.last),n.dirty=!0}function yl(n){let{clientWidth:e,clientHeight:t}=n.canvas;e===0||t===0||n.renderer.xr.isPresenting||(n.resized=!0,n.view.camera.aspect=e/t,n.view.camera.fov=e<t?38:30,n.view.camera.updateProjectionMatrix(),Ji(n.view))}function nT(n){let{clientWidth:e,clientHeight:t}=n.canvas,{pixels:i,shadows:s,rich:r}=gl[n.pace.step];n.renderer.setPixelRatio(n.plain?1:Math.min(i,devicePixelRatio)),e>0&&t>0&&n.renderer.setSize(e,t,!1),n.lights.key.castShadow=n.ground.visible=s;for(let o of Yn(n))Od(o,r);n.resized=!1,n.moved=!0}function K_(n){let e=n.renderer.getContext(),t=performance.now();if(n.fence&&!e.isContextLost()){if(e.getSyncParameter(n.fence,e.SYNC_STATUS)!==e.SIGNALED)return!1;e.deleteSync(n.fence),n.fence=null;let i=.001*(t-n.begun);n.rested=t+1e3*H_(i,n.plain),n.resized||=V_(n.pace,i)}return t>=n.rested}function Q_(n){if(!(n.dirty||n.view.changed))return!1;let e=n.renderer.getContext();return n.resized&&nT(n),KA(n),n.dirty=n.view.changed=!1,n.renderer.shadowMap.needsUpdate=n.moved,n.moved=!1,n.begun=performance.now(),n.renderer.render(n.scene,n.view.camera),n.fence=e.fenceSync(e.SYNC_GPU_COMMANDS_COMPLETE,0),e.flush(),!0}function ex(n,e){let t=n.root.localToWorld(new B(...e));return 2*Math.tan(n.view.camera.fov*Math.PI/360)*sl(n.view,t)*n.radius/Math.max(1,n.canvas.clientHeight)}var tx=.008;function nx(n){let{canvas:e}=n.stage,t={player:n,pointers:new Map,mode:null,keys:new Set,touch:matchMedia("(pointer: coarse)").matches};e.addEventListener("contextmenu",i=>i.preventDefault()),e.addEventListener("pointerdown",i=>iT(t,i)),e.addEventListener("pointermove",i=>rT(t,i));for(let i of["pointerup","pointercancel"])e.addEventListener(i,s=>lT(t,s));return e.addEventListener("wheel",i=>cT(t,i),{passive:!1}),addEventListener("keydown",i=>hT(t,i)),addEventListener("keyup",({key:i})=>t.keys.delete(i)),addEventListener("blur",()=>t.keys.clear()),e.addEventListener("dblclick",i=>{i.button===2&&zu(n.stage.view)}),t}function iT(n,e){let{canvas:t}=n.player.stage;t.focus({preventScroll:!0}),!n.player.claims(e)&&(t.setPointerCapture(e.pointerId),n.pointers.set(e.pointerId,{x:e.clientX,y:e.clientY}),n.touch=e.pointerType==="touch",n.touch?n.pointers.size===1&&(n.mode=sT(n,e)&&n.player.mayMove()?"hand":"view"):e.button===0?n.mode=n.player.mayMove()?"hand":"view":n.mode=e.button===1||e.shiftKey?"pan":"view",n.mode==="hand"&&n.player.press(),t.classList.toggle("grabbing",n.mode==="hand"))}function sT({player:{stage:n}},e){if(!n.object)return!1;let t=n.canvas.getBoundingClientRect(),i=new ct((e.clientX-t.left)/t.width*2-1,1-(e.clientY-t.top)/t.height*2),s=new Er;return s.setFromCamera(i,n.view.camera),s.intersectObject(n.object.finest.solid,!1).length>0}function rT(n,e){let t=n.pointers.get(e.pointerId);if(t){if(n.pointers.size===2)aT(n,e,t);else{let i=e.getCoalescedEvents?.()??[];for(let s of i.length>0?i:[e])oT(n,s,s.clientX-t.x,s.clientY-t.y),t.x=s.clientX,t.y=s.clientY}t.x=e.clientX,t.y=e.clientY,n.mode==="hand"&&n.player.give()}}function oT(n,e,t,i){let{stage:s}=n.player;if(!(t===0&&i===0)){if(n.mode==="view")return ad(s.view,t,i);if(n.mode==="pan")return ld(s.view,t,i,s.canvas.clientHeight);if(n.mode==="hand")return e.ctrlKey||e.altKey||e.metaKey?rh(n,t,i,0,e.timeStamp):e.shiftKey?Vo(n,0,0,-i,e.timeStamp):Vo(n,t,i,0,e.timeStamp)}}function Vo(n,e,t,i,s){let{stage:r,hand:o}=n.player,a=ex(r,n.player.grasp()),{right:l,up:c,forward:u}=ar(r.view),f=[0,1,2].map(h=>a*(e*l.getComponent(h)-t*c.getComponent(h)+i*u.getComponent(h)));qu(o,f,n.player.workspace()),cr(o,s/1e3),n.player.moved(!1)}function rh(n,e,t,i,s){let{stage:r,hand:o}=n.player,{right:a,up:l,forward:c}=ar(r.view),u=n.player.workspace();Yu(o,l.toArray(),tx*e,u),Yu(o,a.toArray(),tx*t,u),i!==0&&Yu(o,c.toArray(),i,u),cr(o,s/1e3),n.player.moved(!0)}function aT(n,e,t){let[i]=[...n.pointers].filter(([f])=>f!==e.pointerId).map(([,f])=>f),s={x:t.x-i.x,y:t.y-i.y},r={x:e.clientX-i.x,y:e.clientY-i.y},o=(Math.hypot(r.x,r.y)||1)/(Math.hypot(s.x,s.y)||1),a=Math.atan2(s.x*r.y-s.y*r.x,s.x*r.x+s.y*r.y),l=.5*(e.clientX-t.x),c=.5*(e.clientY-t.y),{stage:u}=n.player;n.mode==="hand"?(rh(n,l,c,a,e.timeStamp),Vo(n,0,0,-200*Math.log(o),e.timeStamp)):(ld(u.view,l,c,u.canvas.clientHeight),ko(u.view,1/o))}function lT(n,e){n.pointers.delete(e.pointerId),!(n.pointers.size>0)&&(n.mode=null,n.player.stage.canvas.classList.remove("grabbing"))}function cT(n,e){e.preventDefault();let t=e.deltaY*(e.deltaMode===1?16:e.deltaMode===2?400:1);n.mode==="hand"?(Vo(n,0,0,-.4*t,e.timeStamp),n.player.give()):ko(n.player.stage.view,Math.exp(.0012*t))}var ix={ArrowLeft:[-1,0,0],ArrowRight:[1,0,0],ArrowUp:[0,-1,0],ArrowDown:[0,1,0],PageUp:[0,0,1],PageDown:[0,0,-1]},uT=160;function hT(n,e){let t=e.target===n.player.stage.canvas||e.target===document.body;!ix[e.key]||!t||(e.preventDefault(),Object.assign(n,{turns:e.ctrlKey||e.altKey||e.metaKey,views:e.shiftKey}),n.keys.add(e.key))}function sx(n,e){if(n.keys.size===0)return;let{hand:t,stage:i}=n.player,s=uT*Math.min(.1,e),[r,o,a]=[0,1,2].map(l=>s*[...n.keys].reduce((c,u)=>c+ix[u][l],0));!t.clutch||n.views?(ad(i.view,r,o),a!==0&&ko(i.view,Math.exp(-.004*a))):n.turns?rh(n,r,o,.01*a,performance.now()):Vo(n,r,o,a,performance.now()),n.player.give()}var fT=.12;function rx(n,e,t,i){let s=[...navigator.getGamepads?.()??[]].find(a=>a?.connected);if(!s)return!1;let{player:r}=n,o=a=>Math.abs(s.axes[a]??0)>fT?s.axes[a]:0;if(s.buttons[0]?.pressed&&r.mayMove()&&r.press(),s.buttons[1]?.pressed&&r.letGo(),r.hand.clutch){let a=220*Math.min(.1,e),l=(s.buttons[7]?.value??0)-(s.buttons[6]?.value??0);(o(0)||o(1)||l)&&Vo(n,a*o(0),a*o(1),a*l,performance.now()),(o(2)||o(3))&&rh(n,a*o(2),a*o(3),0,performance.now())}return dT(n,s,Math.min(1,t/i)),!0}function dT(n,e,t){let i=performance.now();!e.vibrationActuator?.playEffect||t<.02||i-(n.rumbled??-1e9)<60||(n.rumbled=i,e.vibrationActuator.playEffect("dual-rumble",{duration:80,strongMagnitude:t,weakMagnitude:.5*t}).catch(()=>{}))}function ox(n,e){let t={url:n,on:e,worker:new Worker("worker.js"),isOpen:!1,attempt:0,nextId:1,asked:new Map,received:0,bytes:0,posted:0,gone:0,stopped:!1};return t.worker.onmessage=({data:i})=>pT(t,i),t.worker.onerror=()=>hx(t,"The page could not start its worker. Reload the page."),t.worker.postMessage({open:n,origin:performance.timeOrigin}),t}function pT(n,e){if(!n.stopped)if(e.data!==void 0)try{mT(n,e.data)}finally{n.worker.postMessage({taken:1})}else e.opened?(Object.assign(n,{isOpen:!0,attempt:0}),n.on.opened()):e.lost?fx(n,e.lost):e.gone!==void 0&&(n.gone=e.gone)}function mT(n,e){if(!n.isOpen)return;n.received+=1,n.bytes+=typeof e=="string"?e.length:e.byteLength;let t=null;try{t=typeof e=="string"?E0(e):w0(e)}catch(i){if(!(i instanceof al))throw i;hx(n,`The program says something this page does not understand: ${i.message}. Reload the page.`);return}t.type==="ack"&&gT(n,t),n.on.message(t)}function gT(n,e){let t=n.asked.get(e.id);n.asked.delete(e.id),t?.(e)}function fr(n,e){if(!n.isOpen)return Promise.resolve({ok:!1,reason:"The program is not connected."});let t=n.nextId;return n.nextId=t===2147483647?1:t+1,n.worker.postMessage({text:JSON.stringify({...e,id:t})}),new Promise(i=>n.asked.set(t,i))}function ax(n,e){n.isOpen&&e.length>0&&n.worker.postMessage({hand:e})}var lx=n=>n?.worker.postMessage({letGo:!0});function cx(n,e){return n.isOpen?(n.posted+=e.byteLength,n.worker.postMessage({bytes:e},[e]),!0):!1}var ux=n=>Math.max(0,n.posted-n.gone);function hx(n,e){n.stopped=!0,n.worker.postMessage({stop:!0}),fx(n,e)}function fx(n,e){Object.assign(n,{isOpen:!1,posted:0,gone:0,attempt:n.attempt+1});for(let t of n.asked.values())t({ok:!1,reason:"The connection was lost."});n.asked.clear(),n.on.lost(e)}function le(n,e="",t=""){return Object.assign(document.createElement(n),{className:e,textContent:t})}function Bn(n,e,t=""){let i=Object.assign(le("button",t,n),{type:"button"});return i.addEventListener("click",e),i}function _T({min:n,max:e,scale:t},i){let s=t==="log"?Math.log(i/n)/Math.log(e/n):(i-n)/(e-n);return Math.max(0,Math.min(1,s))}function dx({min:n,max:e,scale:t},i){return t==="log"?n*(e/n)**i:n+i*(e-n)}var Sl=n=>String(Number(n.toPrecision(3)));function px(n,e){return{parent:n,ask:e,rows:new Map}}function mx(n,e){let t=new Set(e.map(i=>i.name));for(let[i,s]of n.rows)t.has(i)||(s.box.remove(),n.rows.delete(i));for(let i of e)n.rows.has(i.name)||n.rows.set(i.name,vT(n,i)),yT(n.rows.get(i.name),i)}function xT(n,e){let t=le("div","parameter"),i=le("div","parameter-top"),s=le("span","words"),r=le("label","",e.label),o=le("p","note"),a=le("p","refusal"),l=le("p","warning");a.setAttribute("role","alert"),s.setAttribute("role","radiogroup"),s.setAttribute("aria-label",e.label);let c=e.choices.map((f,h)=>{let p=Object.assign(le("button","chip-button",f),{type:"button"});return p.setAttribute("role","radio"),p.addEventListener("click",()=>{u.parameter.value!==h&&Ml(n,u,h)}),s.append(p),p});i.append(r,s),t.append(i,o,a,l),n.parent.append(t);let u={box:t,buttons:c,help:o,refusal:a,warning:l,parameter:e,busy:!1,next:null};return u}function vT(n,e){if(e.kind==="choice")return xT(n,e);let t=le("div","parameter"),i=le("label","",e.label),s=Object.assign(le("input"),{type:"range",min:0,max:1,step:.001,id:`parameter-${e.name}`});i.htmlFor=s.id;let r=Object.assign(le("input","value"),{type:"text",inputMode:"decimal"});r.setAttribute("aria-label",`${e.label}, ${e.unit}`);let o=le("span","unit",e.unit),a=le("p","note"),l=le("p","refusal");l.setAttribute("role","alert");let c=le("div","parameter-top"),u=le("p","warning"),f={box:t,slider:s,number:r,help:a,refusal:l,warning:u,parameter:e,busy:!1,next:null,on:null};return e.kind==="optional"&&(f.on=Object.assign(le("input","switch"),{type:"checkbox"}),f.on.setAttribute("aria-label",`${e.label} on`),f.kept=e.value||dx(e,.5),f.on.addEventListener("change",()=>Ml(n,f,f.on.checked?Number(Sl(f.kept)):0)),c.append(f.on)),c.append(i,r,o),t.append(c,s,a,l,u),n.parent.append(t),s.addEventListener("input",()=>{let h=Number(Sl(dx(f.parameter,Number(s.value))));r.value=Sl(h),Ml(n,f,h)}),r.addEventListener("change",()=>{let h=Number(r.value.replace(",","."));r.value.trim()!==""&&Number.isFinite(h)?Ml(n,f,h):gx(f,`"${r.value}" is not a number.`)}),f}async function Ml(n,e,t){if(e.busy){e.next=t;return}e.busy=!0;let i=await n.ask(e.parameter.name,t);if(e.busy=!1,e.next!==null){let s=e.next;e.next=null,Ml(n,e,s);return}if(!i.ok){gx(e,i.reason??"Refused.");return}e.refusal.textContent="",e.parameter={...e.parameter,value:i.value??t},Vd(e),e.box.classList.remove("changed"),e.box.offsetWidth,e.box.classList.add("changed")}function gx(n,e){let{value:t,unit:i,choices:s}=n.parameter,r=s?.length>0?s[t]:n.on&&t===0?"off":`${Sl(t)} ${i}`.trim();n.refusal.textContent=`${e.replace(/[.]?$/,".")} It stays at ${r}.`,Vd(n)}function yT(n,e){n.parameter=e;let t=e.begins_again?" Begins again.":"";n.help.textContent=e.locked??`${e.help??""}${t}`,n.warning.textContent=e.warning?`Risky: ${e.warning}.`:"";let i=!!e.locked;n.box.classList.toggle("locked",i);for(let s of[n.slider,n.number,n.on,...n.buttons??[]])s&&(s.disabled=i);!n.busy&&document.activeElement!==n.number&&Vd(n)}function Vd(n){let{value:e}=n.parameter;if(n.buttons?.forEach((i,s)=>i.setAttribute("aria-checked",String(s===e))),n.buttons)return;let t=n.on!==null&&e===0;n.on&&(n.on.checked=!t,t||(n.kept=e),n.box.classList.toggle("off",t)),n.slider.value=_T(n.parameter,t?n.kept:e),n.number.value=t?"off":Sl(e)}var ST=200;function _x(n,e){let t=le("div",`event ${e.kind}`);for(t.append(le("time","",`${Ii(e.time)} s`),le("span","",Hu(e))),n.prepend(t);n.childElementCount>ST;)n.lastChild.remove()}var MT=[["Drag","moves the hand in the plane of the screen"],["Wheel while dragging, or Shift + drag","moves it away from you and back"],["Ctrl or Alt + drag","turns it"],["Space","lets go, or takes hold"],["Arrow keys, Page up and down","move the hand that holds, on the picture; with Ctrl or Alt they turn it, with Shift the view"],["Right drag, wheel","turns and zooms the view; middle drag shifts it"],["Touch","one finger on the object moves it, a second turns and lifts it; beside it fingers move the view"],["Gamepad","sticks move and turn, triggers push and pull, A holds, B lets go; it rumbles with the force"],["VR or AR","where a headset is there: the trigger holds, squeezing frees the controller, its stick turns and sizes the scene"],["Scene tab","put a scene together: drop meshes, drag the handles, Ctrl+Z takes a step back"],["P . R O","pause, one step, begin again, open a scene"],["F L G C A N","fit the view; levels of detail, ghost, contacts, arrows, names on and off"],["S","sound of contact on and off: changes of the force"],["1 to 6, + -","look along the axes, as the buttons of the compass do; nearer and farther"]];function xx(n){let e=le("h2","","The mouse is the hand"),t=le("p","lead","Drag the blue object: the ghost shows where your hand is, the object where it may be, and the line between them, as long as the force is strong, is what a haptic device would let you feel."),i=le("dl");for(let[o,a]of MT){let l=/^(Drag|Touch|Gamepad)$/.test(o)?"":"for-mouse";i.append(le("dt",l,o),le("dd",l,a))}let s=le("p","note");s.append(Ho("force","force on the hand"),Ho("torque","torque, turning along the arc"),Ho("ring","clusters of contacts"),Ho("levels","dots: contacts with their normals, in the colour of their level of detail"),Ho("contact","under constraints, discs: planes that the object keeps off, with the points they keep off"),Ho("press","those that press, with their force and the cone it may lie in"));let r=Object.assign(le("button","primary","Close"),{type:"button"});r.addEventListener("click",()=>n.close()),n.addEventListener("click",o=>{o.target===n&&n.close()}),n.replaceChildren(e,t,i,s,r)}function Ho(n,e){let t=le("span",`key ${n}`,e);return t.prepend(le("i")),t}var bT="uplot",wT="u-hz",ET="u-vt",AT="u-title",TT="u-wrap",CT="u-under",RT="u-over",PT="u-axis",Vr="u-off",IT="u-select",LT="u-cursor-x",NT="u-cursor-y",DT="u-cursor-pt",UT="u-legend",FT="u-live",OT="u-inline",BT="u-series",kT="u-marker",vx="u-label",zT="u-value",wl="width",El="height";var yx="bottom",Wo="left",Hd="right",op="#000",Sx=op+"0",Wd="mousemove",Mx="mousedown",Xd="mouseup",bx="mouseenter",wx="mouseleave",Ex="dblclick",GT="resize",VT="scroll",Ax="change",uh="dppxchange",ap="--",jo=typeof window<"u",Jd=jo?document:null,qo=jo?window:null,HT=jo?navigator:null,Tt,oh;function jd(){let n=devicePixelRatio;Tt!=n&&(Tt=n,oh&&Qd(Ax,oh,jd),oh=matchMedia(`(min-resolution: ${Tt-.001}dppx) and (max-resolution: ${Tt+.001}dppx)`),Hr(Ax,oh,jd),qo.dispatchEvent(new CustomEvent(uh)))}function Si(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Kd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Jt(n,e,t){n.style[e]=t+"px"}function ji(n,e,t,i){let s=Jd.createElement(n);return e!=null&&Si(s,e),t?.insertBefore(s,i),s}function Li(n,e){return ji("div",n,e)}var Tx=new WeakMap;function ms(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Tx.get(n);r!=o&&(n.style.transform=r,Tx.set(n,r),e<0||t<0||e>i||t>s?Si(n,Vr):Kd(n,Vr))}var Cx=new WeakMap;function Rx(n,e,t){let i=e+t,s=Cx.get(n);i!=s&&(Cx.set(n,i),n.style.background=e,n.style.borderColor=t)}var Px=new WeakMap;function Ix(n,e,t,i){let s=e+""+t,r=Px.get(n);s!=r&&(Px.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var lp={passive:!0},WT={...lp,capture:!0};function Hr(n,e,t,i){e.addEventListener(n,t,i?WT:lp)}function Qd(n,e,t,i){e.removeEventListener(n,t,lp)}jo&&jd();function Ki(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Mi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function rv(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var ov=n=>n!=null,av=n=>n!=null&&n>0,dh=rv(ov),XT=rv(av);function qT(n,e,t,i=0,s=!1){let r=s?XT:dh,o=s?av:ov;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Bt,l??-Bt]}function ph(n,e,t,i){let s=Dx(n),r=Dx(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Bs:lv,a=s==1?Mi:Ni,l=r==1?Ni:Mi,c=a(o(Pn(n))),u=l(o(Pn(e))),f=Yo(t,c),h=Yo(t,u);return t==10&&(c<0&&(f=kt(f,-c)),u<0&&(h=kt(h,-u))),i||t==2?(n=f*s,e=h*r):(n=fv(n,f),e=mh(e,h)),[n,e]}function cp(n,e,t,i){let s=ph(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var up=.1,Lx={mode:3,pad:up},Tl={pad:0,soft:null,mode:0},YT={min:Tl,max:Tl};function hh(n,e,t,i){return gh(t)?Nx(n,e,t):(Tl.pad=t,Tl.soft=i?0:null,Tl.mode=i?3:0,Nx(n,e,YT))}function wt(n,e){return n??e}function $T(n,e,t){for(e=wt(e,0),t=wt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Nx(n,e,t){let i=t.min,s=t.max,r=wt(i.pad,0),o=wt(s.pad,0),a=wt(i.hard,-Bt),l=wt(s.hard,Bt),c=wt(i.soft,Bt),u=wt(s.soft,-Bt),f=wt(i.mode,0),h=wt(s.mode,0),p=e-n,g=Bs(p),y=si(Pn(n),Pn(e)),d=Bs(y),m=Pn(d-g);(p<1e-24||m>10)&&(p=0,(n==0||e==0)&&(p=1e-24,f==2&&c!=Bt&&(r=0),h==2&&u!=-Bt&&(o=0)));let v=p||y||1e3,T=Bs(v),S=Yo(10,Mi(T)),C=v*(p==0?n==0?.1:1:r),A=kt(fv(n-C,S/10),24),_=n>=c&&(f==1||f==3&&A<=c||f==2&&A>=c)?c:Bt,w=si(a,A<_&&n>=_?_:Qi(_,A)),U=v*(p==0?e==0?.1:1:o),L=kt(mh(e+U,S/10),24),I=e<=u&&(h==1||h==3&&L>=u||h==2&&L<=u)?u:-Bt,k=Qi(l,L>I&&e<=I?I:si(I,L));return w==k&&w==0&&(k=100),[w,k]}var ZT=new Intl.NumberFormat(jo?HT.language:"en-US"),hp=n=>ZT.format(n),bi=Math,ch=bi.PI,Pn=bi.abs,Mi=bi.floor,Rn=bi.round,Ni=bi.ceil,Qi=bi.min,si=bi.max,Yo=bi.pow,Dx=bi.sign,Bs=bi.log10,lv=bi.log2,JT=(n,e=1)=>bi.sinh(n)*e,qd=(n,e=1)=>bi.asinh(n/e),Bt=1/0;function Ux(n){return(Bs((n^n>>31)-(n>>31))|0)+1}function ep(n,e,t){return Qi(si(n,e),t)}function cv(n){return typeof n=="function"}function yt(n){return cv(n)?n:()=>n}var jT=()=>{},uv=n=>n,hv=(n,e)=>e,KT=n=>null,Fx=n=>!0,Ox=(n,e)=>n==e,QT=/\.\d*?(?=9{6,}|0{6,})/gm,Wr=n=>{if(pv(n)||pr.has(n))return n;let e=`${n}`,t=e.match(QT);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Wr(s)}e${r}`}return kt(n,i)};function zr(n,e){return Wr(kt(Wr(n/e))*e)}function mh(n,e){return Wr(Ni(Wr(n/e))*e)}function fv(n,e){return Wr(Mi(Wr(n/e))*e)}function kt(n,e=0){if(pv(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Rn(i)/t}var pr=new Map;function dv(n){return((""+n).split(".")[1]||"").length}function Rl(n,e,t,i){let s=[],r=i.map(dv);for(let o=e;o<t;o++){let a=Pn(o),l=kt(Yo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:kt(u,f);s.push(h),pr.set(h,f)}}return s}var Cl={},fp=[],$o=[null,null],dr=Array.isArray,pv=Number.isInteger,eC=n=>n===void 0;function Bx(n){return typeof n=="string"}function gh(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function tC(n){return n!=null&&typeof n=="object"}var nC=Object.getPrototypeOf(Uint8Array),mv="__proto__";function Zo(n,e=gh){let t;if(dr(n)){let i=n.find(s=>s!=null);if(dr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Zo(n[s],e)}else t=n.slice()}else if(n instanceof nC)t=n.slice();else if(e(n)){t={};for(let i in n)i!=mv&&(t[i]=Zo(n[i],e))}else t=n;return t}function wn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=mv&&(gh(n[s])?wn(n[s],Zo(i[s])):n[s]=Zo(i[s]))}return n}var iC=0,sC=1,rC=2;function oC(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function aC(n,e){if(uC(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return hC(o[0])||(o=cC(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:sC,p=[];for(let g=0;g<u.length;g++){let y=u[g],d=r.get(l[g]);y===null?h!=iC&&(f[d]=y,h==rC&&p.push(d)):f[d]=y}oC(f,p,s),i.push(f)}}return i}var lC=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function cC(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function uC(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function hC(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=si(1,Mi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var gv=["January","February","March","April","May","June","July","August","September","October","November","December"],_v=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function xv(n){return n.slice(0,3)}var fC=_v.map(xv),dC=gv.map(xv),pC={MMMM:gv,MMM:dC,WWWW:_v,WWW:fC};function bl(n){return(n<10?"0":"")+n}function mC(n){return(n<10?"00":n<100?"0":"")+n}var gC={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>bl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>bl(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>bl(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>bl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>bl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>mC(n.getMilliseconds())};function dp(n,e){e=e||pC;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?gC[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var _C=new Intl.DateTimeFormat().resolvedOptions().timeZone;function xC(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==_C?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var vv=n=>n%1==0,fh=[1,2,2.5,5],vC=Rl(10,-32,0,fh),yv=Rl(10,0,32,fh),yC=yv.filter(vv),Gr=vC.concat(yv),pp=`
`,Sv="{YYYY}",kx=pp+Sv,Mv="{M}/{D}",Al=pp+Mv,ah=Al+"/{YY}",bv="{aa}",SC="{h}:{mm}",Xo=SC+bv,zx=pp+Xo,Gx=":{ss}",Pt=null;function wv(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Rl(10,0,3,fh).filter(vv):Rl(10,-3,0,fh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Sv,Pt,Pt,Pt,Pt,Pt,Pt,1],[s*28,"{MMM}",kx,Pt,Pt,Pt,Pt,Pt,1],[s,Mv,kx,Pt,Pt,Pt,Pt,Pt,1],[i,"{h}"+bv,ah,Pt,Al,Pt,Pt,Pt,1],[t,Xo,ah,Pt,Al,Pt,Pt,Pt,1],[e,Gx,ah+" "+Xo,Pt,Al+" "+Xo,Pt,zx,Pt,1],[n,Gx+".{fff}",ah+" "+Xo,Pt,Al+" "+Xo,Pt,zx,Pt,1]];function u(f){return(h,p,g,y,d,m)=>{let v=[],T=d>=o,S=d>=r&&d<o,C=f(g),A=kt(C*n,3),_=Yd(C.getFullYear(),T?0:C.getMonth(),S||T?1:C.getDate()),w=kt(_*n,3);if(S||T){let U=S?d/r:0,L=T?d/o:0,I=A==w?A:kt(Yd(_.getFullYear()+L,_.getMonth()+U,1)*n,3),k=new Date(Rn(I/n)),W=k.getFullYear(),N=k.getMonth();for(let V=0;I<=y;V++){let Y=Yd(W+L*V,N+U*V,1),G=Y-f(kt(Y*n,3));I=kt((+Y+G)*n,3),I<=y&&v.push(I)}}else{let U=d>=s?s:d,L=Mi(g)-Mi(A),I=w+L+mh(A-w,U);v.push(I);let k=f(I),W=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,N=d/i,V=h.axes[p]._space,Y=m/V;for(;I=kt(I+d,n==1?0:3),!(I>y);)if(N>1){let G=Mi(kt(W+N,6))%24,K=f(I).getHours()-G;K>1&&(K=-1),I-=K*i,W=(W+N)%24;let ne=v[v.length-1];kt((I-ne)/d,3)*Y>=.7&&v.push(I)}else v.push(I)}return v}}return[l,c,u]}var[MC,bC,wC]=wv(1),[EC,AC,TC]=wv(.001);Rl(2,-53,53,[1]);function Vx(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Hx(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,f,h,p;return i.map(g=>{let y=n(g),d=y.getFullYear(),m=y.getMonth(),v=y.getDate(),T=y.getHours(),S=y.getMinutes(),C=y.getSeconds(),A=d!=l&&a[2]||m!=c&&a[3]||v!=u&&a[4]||T!=f&&a[5]||S!=h&&a[6]||C!=p&&a[7]||a[1];return l=d,c=m,u=v,f=T,h=S,p=C,A(y)})}}function CC(n,e){let t=dp(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Yd(n,e,t){return new Date(n,e,t)}function Wx(n,e){return e(n)}var RC="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Xx(n,e){return(t,i,s,r)=>r==null?ap:e(n(i))}function PC(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function IC(n,e){return n.series[e].fill(n,e)}var LC={show:!0,live:!0,isolate:!1,mount:jT,markers:{show:!0,width:2,stroke:PC,fill:IC,dash:"solid"},idx:null,idxs:null,values:[]};function NC(n,e){let t=n.cursor.points,i=Li(),s=t.size(n,e);Jt(i,wl,s),Jt(i,El,s);let r=s/-2;Jt(i,"marginLeft",r),Jt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Jt(i,"borderWidth",o),i}function DC(n,e){let t=n.series[e].points;return t._fill||t._stroke}function UC(n,e){let t=n.series[e].points;return t._stroke||t._fill}function FC(n,e){return n.series[e].points.size}var $d=[0,0];function OC(n,e,t){return $d[0]=e,$d[1]=t,$d}function lh(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Zd(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var BC={show:!0,x:!0,y:!0,lock:!1,move:OC,points:{one:!1,show:NC,size:FC,width:0,stroke:UC,fill:DC},bind:{mousedown:lh,mouseup:lh,click:lh,dblclick:lh,mousemove:Zd,mouseleave:Zd,mouseenter:Zd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Ev={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},mp=wn({},Ev,{filter:hv}),Av=wn({},mp,{size:10}),Tv=wn({},Ev,{show:!1}),gp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Cv="bold "+gp,Rv=1.5,qx={show:!0,scale:"x",stroke:op,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Cv,side:2,grid:mp,ticks:Av,border:Tv,font:gp,lineGap:Rv,rotate:0},kC="Value",zC="Time",Yx={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function GC(n,e,t,i,s){return e.map(r=>r==null?"":hp(r))}function VC(n,e,t,i,s,r,o){let a=[],l=pr.get(s)||0;t=o?t:kt(mh(t,s),l);for(let c=t;c<=i;c=kt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function tp(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Bs:lv,u=Mi(c(t));s=Yo(l,u),l==10&&(s=Gr[Ki(s,Gr)]);let f=t,h=s*l;l==10&&(h=Gr[Ki(h,Gr)]);do a.push(f),f=f+s,l==10&&!pr.has(f)&&(f=kt(f,pr.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=Gr[Ki(h,Gr)]));while(f<=i);return a}function HC(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?tp(n,e,si(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?tp(n,e,si(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var Pv=/./,WC=/[12357]/,XC=/[125]/,$x=/1/,np=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function qC(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?Pv:l(7,o)-u>=c?WC:l(5,o)-u>=c?XC:$x;if(f==$x){let h=Pn(l(1,o)-u);if(h<c)return np(e.slice().reverse(),a.distr,f,Ni(c/h)).reverse()}return np(e,a.distr,f,1)}function YC(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Pn(l(1,o)-l(2,o));return c<a?np(e.slice().reverse(),3,Pv,Ni(a/c)).reverse():e}function $C(n,e,t,i){return i==null?ap:e==null?"":hp(e)}var Zx={show:!0,scale:"y",stroke:op,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Cv,side:3,grid:mp,ticks:Av,border:Tv,font:gp,lineGap:Rv,rotate:0};function ZC(n,e){let t=3+(n||1)*2;return kt(t*e,3)}function JC(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Pn(o-r),l=n.series[e],c=a/(l.points.space*Tt);return i[1]-i[0]<=c}var Jx={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},Iv=(n,e,t,i,s)=>s,jx={show:!0,auto:!0,sorted:0,gaps:Iv,alpha:1,facets:[wn({},Jx,{scale:"x"}),wn({},Jx,{scale:"y"})]},Kx={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Iv,alpha:1,points:{show:JC,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function jC(n,e,t,i,s){return t/10}var Lv={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},KC=wn({},Lv,{time:!1,ori:1}),Qx={};function Nv(n,e){let t=Qx[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Qx[n]=t)),t}var Jo=1,ip=2;function Xr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,p=a.top,g=a.width,y=a.height,d=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,f,d,m,h,p,g,y,xh,Ko,yh,Uv,Ov):t(s,l,c,u,f,m,d,p,h,y,g,vh,Qo,vp,Fv,Bv)}function _p(n,e){let t=0,i=0,s=wt(n.bands,fp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function QC(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ks(n,e,t,i,s,r){return Xr(n,e,(o,a,l,c,u,f,h,p,g,y,d)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),T=c.ori==0?Ko:Qo,S,C;v==1?(S=t,C=i):(S=i,C=t);let A=m(f(a[S],c,y,p)),_=m(h(l[S],u,d,g)),w=m(f(a[C],c,y,p)),U=m(h(r==1?u.max:u.min,u,d,g)),L=new Path2D(s);return T(L,w,U),T(L,A,U),T(L,A,_),L})}function _h(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?yh:vp,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let p=h[0]-l;p>0&&a(o,l,i,p,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function eR(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function xp(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let p=r(n[f]),g=h==f?p:r(n[h]),y=f-s;p=o<=0&&y>=0&&y<l?r(n[y]):p;let m=h+s;g=o>=0&&m>=0&&m<l?r(n[m]):g,g>=p&&a.push([p,g])}return a}function ev(n){return n==0?uv:n==1?Rn:e=>zr(e,n)}function Dv(n){let e=n==0?xh:vh,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Qi(c,a/2,l/2),u=Qi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var xh=(n,e,t)=>{n.moveTo(e,t)},vh=(n,e,t)=>{n.moveTo(t,e)},Ko=(n,e,t)=>{n.lineTo(e,t)},Qo=(n,e,t)=>{n.lineTo(t,e)},yh=Dv(0),vp=Dv(1),Uv=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Fv=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Ov=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Bv=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function kv(n){return(e,t,i,s,r)=>Xr(e,t,(o,a,l,c,u,f,h,p,g,y,d)=>{let{pxRound:m,points:v}=o,T,S;c.ori==0?(T=xh,S=Uv):(T=vh,S=Fv);let C=kt(v.width*Tt,3),A=(v.size-v.width)/2*Tt,_=kt(A*2,3),w=new Path2D,U=new Path2D,{left:L,top:I,width:k,height:W}=e.bbox;yh(U,L-_,I-_,k+_*2,W+_*2);let N=V=>{if(l[V]!=null){let Y=m(f(a[V],c,y,p)),G=m(h(l[V],u,d,g));T(w,Y+A,G),S(w,Y,G,A,0,ch*2)}};if(r)r.forEach(N);else for(let V=i;V<=s;V++)N(V);return{stroke:C>0?w:null,fill:w,clip:U,flags:Jo|ip}})}function zv(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var tR=zv(Ko),nR=zv(Qo);function Gv(n){let e=wt(n?.alignGaps,0);return(t,i,s,r)=>Xr(t,i,(o,a,l,c,u,f,h,p,g,y,d)=>{[s,r]=dh(l,s,r);let m=o.pxRound,v=W=>m(f(W,c,y,p)),T=W=>m(h(W,u,d,g)),S,C;c.ori==0?(S=Ko,C=tR):(S=Qo,C=nR);let A=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Jo},w=_.stroke,U=!1;if(r-s>=y*4){let W=fe=>t.posToVal(fe,c.key,!0),N=null,V=null,Y,G,ae,q=v(a[A==1?s:r]),K=v(a[s]),ne=v(a[r]),he=W(A==1?K+1:ne-1);for(let fe=A==1?s:r;fe>=s&&fe<=r;fe+=A){let Q=a[fe],ve=(A==1?Q<he:Q>he)?q:v(Q),Re=l[fe];ve==q?Re!=null?(G=Re,N==null?(S(w,ve,T(G)),Y=N=V=G):G<N?N=G:G>V&&(V=G)):Re===null&&(U=!0):(N!=null&&C(w,q,T(N),T(V),T(Y),T(G)),Re!=null?(G=Re,S(w,ve,T(G)),N=V=Y=G):(N=V=null,Re===null&&(U=!0)),q=ve,he=W(q+A))}N!=null&&N!=V&&ae!=q&&C(w,q,T(N),T(V),T(Y),T(G))}else for(let W=A==1?s:r;W>=s&&W<=r;W+=A){let N=l[W];N===null?U=!0:N!=null&&S(w,v(a[W]),T(N))}let[I,k]=_p(t,i);if(o.fill!=null||I!=0){let W=_.fill=new Path2D(w),N=o.fillTo(t,i,o.min,o.max,I),V=T(N),Y=v(a[s]),G=v(a[r]);A==-1&&([G,Y]=[Y,G]),S(W,G,V),S(W,Y,V)}if(!o.spanGaps){let W=[];U&&W.push(...xp(a,l,s,r,A,v,e)),_.gaps=W=o.gaps(t,i,s,r,W),_.clip=_h(W,c.ori,p,g,y,d)}return k!=0&&(_.band=k==2?[ks(t,i,s,r,w,-1),ks(t,i,s,r,w,1)]:ks(t,i,s,r,w,k)),_})}function iR(n){let e=wt(n.align,1),t=wt(n.ascDesc,!1),i=wt(n.alignGaps,0),s=wt(n.extend,!1);return(r,o,a,l)=>Xr(r,o,(c,u,f,h,p,g,y,d,m,v,T)=>{[a,l]=dh(f,a,l);let S=c.pxRound,{left:C,width:A}=r.bbox,_=K=>S(g(K,h,v,d)),w=K=>S(y(K,p,T,m)),U=h.ori==0?Ko:Qo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Jo},I=L.stroke,k=h.dir*(h.ori==0?1:-1),W=w(f[k==1?a:l]),N=_(u[k==1?a:l]),V=N,Y=N;s&&e==-1&&(Y=C,U(I,Y,W)),U(I,N,W);for(let K=k==1?a:l;K>=a&&K<=l;K+=k){let ne=f[K];if(ne==null)continue;let he=_(u[K]),fe=w(ne);e==1?U(I,he,W):U(I,V,fe),U(I,he,fe),W=fe,V=he}let G=V;s&&e==1&&(G=C+A,U(I,G,W));let[ae,q]=_p(r,o);if(c.fill!=null||ae!=0){let K=L.fill=new Path2D(I),ne=c.fillTo(r,o,c.min,c.max,ae),he=w(ne);U(K,G,he),U(K,Y,he)}if(!c.spanGaps){let K=[];K.push(...xp(u,f,a,l,k,_,i));let ne=c.width*Tt/2,he=t||e==1?ne:-ne,fe=t||e==-1?-ne:ne;K.forEach(Q=>{Q[0]+=he,Q[1]+=fe}),L.gaps=K=c.gaps(r,o,a,l,K),L.clip=_h(K,h.ori,d,m,v,T)}return q!=0&&(L.band=q==2?[ks(r,o,a,l,I,-1),ks(r,o,a,l,I,1)]:ks(r,o,a,l,I,q)),L})}function tv(n,e,t,i,s,r,o=Bt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Pn(n[l]-n[a]);u<c&&(c=u,o=Pn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function sR(n){n=n||Cl;let e=wt(n.size,[.6,Bt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=wt(e[1],Bt),l=wt(e[2],1),c=wt(n.disp,Cl),u=wt(n.each,p=>{}),{fill:f,stroke:h}=c;return(p,g,y,d)=>Xr(p,g,(m,v,T,S,C,A,_,w,U,L,I)=>{let k=m.pxRound,W=t,N=i*Tt,V=a*Tt,Y=l*Tt,G,ae;S.ori==0?[G,ae]=r(p,g):[ae,G]=r(p,g);let q=S.dir*(S.ori==0?1:-1),K=S.ori==0?yh:vp,ne=S.ori==0?u:(Ie,Ze,at,Ee,Ot,Ve,$e)=>{u(Ie,Ze,at,Ot,Ee,$e,Ve)},he=wt(p.bands,fp).find(Ie=>Ie.series[0]==g),fe=he!=null?he.dir:0,Q=m.fillTo(p,g,m.min,m.max,fe),ge=k(_(Q,C,I,U)),ve,Re,we,Xe=L,ot=k(m.width*Tt),He=!1,dt=null,ut=null,st=null,jt=null;f!=null&&(ot==0||h!=null)&&(He=!0,dt=f.values(p,g,y,d),ut=new Map,new Set(dt).forEach(Ie=>{Ie!=null&&ut.set(Ie,new Path2D)}),ot>0&&(st=h.values(p,g,y,d),jt=new Map,new Set(st).forEach(Ie=>{Ie!=null&&jt.set(Ie,new Path2D)})));let{x0:Vt,size:gn}=c;if(Vt!=null&&gn!=null){W=1,v=Vt.values(p,g,y,d),Vt.unit==2&&(v=v.map(at=>p.posToVal(w+at*L,S.key,!0)));let Ie=gn.values(p,g,y,d);gn.unit==2?Re=Ie[0]*L:Re=A(Ie[0],S,L,w)-A(0,S,L,w),Xe=tv(v,T,A,S,L,w,Xe),we=Xe-Re+N}else Xe=tv(v,T,A,S,L,w,Xe),we=Xe*o+N,Re=Xe-we;we<1&&(we=0),ot>=Re/2&&(ot=0),we<5&&(k=uv);let Ut=we>0,In=Xe-we-(Ut?ot:0);Re=k(ep(In,Y,V)),ve=(W==0?Re/2:W==q?0:Re)-W*q*((W==0?N/2:0)+(Ut?ot/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},En=He?null:new Path2D,nn=null;if(he!=null)nn=p.data[he.series[1]];else{let{y0:Ie,y1:Ze}=c;Ie!=null&&Ze!=null&&(T=Ze.values(p,g,y,d),nn=Ie.values(p,g,y,d))}let _n=G*Re,O=ae*Re;for(let Ie=q==1?y:d;Ie>=y&&Ie<=d;Ie+=q){let Ze=T[Ie];if(Ze==null)continue;if(nn!=null){let X=nn[Ie]??0;if(Ze-X==0)continue;ge=_(X,C,I,U)}let at=S.distr!=2||c!=null?v[Ie]:Ie,Ee=A(at,S,L,w),Ot=_(wt(Ze,Q),C,I,U),Ve=k(Ee-ve),$e=k(si(Ot,ge)),R=k(Qi(Ot,ge)),M=$e-R;if(Ze!=null){let X=Ze<0?O:_n,ue=Ze<0?_n:O;He?(ot>0&&st[Ie]!=null&&K(jt.get(st[Ie]),Ve,R+Mi(ot/2),Re,si(0,M-ot),X,ue),dt[Ie]!=null&&K(ut.get(dt[Ie]),Ve,R+Mi(ot/2),Re,si(0,M-ot),X,ue)):K(En,Ve,R+Mi(ot/2),Re,si(0,M-ot),X,ue),ne(p,g,Ie,Ve-ot/2,R,Re+ot,M)}}return ot>0?Mt.stroke=He?jt:En:He||(Mt._fill=m.width==0?m._fill:m._stroke??m._fill,Mt.width=0),Mt.fill=He?ut:En,Mt})}function rR(n,e){let t=wt(e?.alignGaps,0);return(i,s,r,o)=>Xr(i,s,(a,l,c,u,f,h,p,g,y,d,m)=>{[r,o]=dh(c,r,o);let v=a.pxRound,T=G=>v(h(G,u,d,g)),S=G=>v(p(G,f,m,y)),C,A,_;u.ori==0?(C=xh,_=Ko,A=Ov):(C=vh,_=Qo,A=Bv);let w=u.dir*(u.ori==0?1:-1),U=T(l[w==1?r:o]),L=U,I=[],k=[];for(let G=w==1?r:o;G>=r&&G<=o;G+=w)if(c[G]!=null){let q=l[G],K=T(q);I.push(L=K),k.push(S(c[G]))}let W={stroke:n(I,k,C,_,A,v),fill:null,clip:null,band:null,gaps:null,flags:Jo},N=W.stroke,[V,Y]=_p(i,s);if(a.fill!=null||V!=0){let G=W.fill=new Path2D(N),ae=a.fillTo(i,s,a.min,a.max,V),q=S(ae);_(G,L,q),_(G,U,q)}if(!a.spanGaps){let G=[];G.push(...xp(l,c,r,o,w,T,t)),W.gaps=G=a.gaps(i,s,r,o,G),W.clip=_h(G,u.ori,g,y,d,m)}return Y!=0&&(W.band=Y==2?[ks(i,s,r,o,N,-1),ks(i,s,r,o,N,1)]:ks(i,s,r,o,N,Y)),W})}function oR(n){return rR(aR,n)}function aR(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var sp=new Set;function nv(){for(let n of sp)n.syncRect(!0)}jo&&(Hr(GT,qo,nv),Hr(VT,qo,nv,!0),Hr(uh,qo,()=>{zn.pxRatio=Tt}));var lR=Gv(),cR=kv();function iv(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>rp(r,o,e,t))}function uR(n,e){return n.map((t,i)=>i==0?{}:wn({},e,t))}function rp(n,e,t,i){return wn({},e==0?t:i,n)}function Vv(n,e,t){return e==null?$o:[e,t]}var hR=Vv;function fR(n,e,t){return e==null?$o:hh(e,t,up,!0)}function Hv(n,e,t,i){return e==null?$o:ph(e,t,n.scales[i].log,!1)}var dR=Hv;function Wv(n,e,t,i){return e==null?$o:cp(e,t,n.scales[i].log,!1)}var pR=Wv;function mR(n,e,t,i,s){let r=si(Ux(n),Ux(e)),o=e-n,a=Ki(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?pr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function sv(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Rn((t=+s)*Tt))+"px"),[n,e,t]}function gR(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=kt(e[2]*Tt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function zn(n,e,t){let i={mode:wt(n.mode,1)},s=i.mode;function r(x,b,P,D){let H=b.valToPct(x);return D+P*(b.dir==-1?1-H:H)}function o(x,b,P,D){let H=b.valToPct(x);return D+P*(b.dir==-1?H:1-H)}function a(x,b,P,D){return b.ori==0?r(x,b,P,D):o(x,b,P,D)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Li(bT);if(n.id!=null&&(c.id=n.id),Si(c,n.class),n.title){let x=Li(AT,c);x.textContent=n.title}let u=ji("canvas"),f=i.ctx=u.getContext("2d"),h=Li(TT,c);Hr("click",h,x=>{x.target===g&&(qt!=to||Kt!=no)&&kn.click(i,x)},!0);let p=i.under=Li(CT,h);h.appendChild(u);let g=i.over=Li(RT,h);n=Zo(n);let y=+wt(n.pxAlign,1),d=ev(y);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let m=n.ms||.001,v=i.series=s==1?iv(n.series||[],Yx,Kx,!1):uR(n.series||[null],jx),T=i.axes=iv(n.axes||[],qx,Zx,!0),S=i.scales={},C=i.bands=n.bands||[];C.forEach(x=>{x.fill=yt(x.fill||null),x.dir=wt(x.dir,-1)});let A=s==2?v[1].facets[0].scale:v[0].scale,_={axes:ys,series:mt},w=(n.drawOrder||["axes","series"]).map(x=>_[x]);function U(x){let b=x.distr==3?P=>Bs(P>0?P:x.clamp(i,P,x.min,x.max,x.key)):x.distr==4?P=>qd(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let D=b(P),{_min:H,_max:J}=x,oe=J-H;return(D-H)/oe}}function L(x){let b=S[x];if(b==null){let P=(n.scales||Cl)[x]||Cl;if(P.from!=null){L(P.from);let D=wn({},S[P.from],P,{key:x});D.valToPct=U(D),S[x]=D}else{b=S[x]=wn({},x==A?Lv:KC,P),b.key=x;let D=b.time,H=b.range,J=dr(H);if((x!=A||s==2&&!D)&&(J&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?Lx:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?Lx:{mode:1,hard:H[1],soft:H[1]}},J=!1),!J&&gh(H))){let oe=H;H=(pe,Se,Ue)=>Se==null?$o:hh(Se,Ue,oe)}b.range=yt(H||(D?hR:x==A?b.distr==3?dR:b.distr==4?pR:Vv:b.distr==3?Hv:b.distr==4?Wv:fR)),b.auto=yt(J?!1:b.auto),b.clamp=yt(b.clamp||jC),b._min=b._max=null,b.valToPct=U(b)}}}L("x"),L("y"),s==1&&v.forEach(x=>{L(x.scale)}),T.forEach(x=>{L(x.scale)});for(let x in n.scales)L(x);let I=S[A],k=I.distr,W,N;I.ori==0?(Si(c,wT),W=r,N=o):(Si(c,ET),W=o,N=r);let V={};for(let x in S){let b=S[x];(b.min!=null||b.max!=null)&&(V[x]={min:b.min,max:b.max},b.min=b.max=null)}let Y=n.tzDate||(x=>new Date(Rn(x/m))),G=n.fmtDate||dp,ae=m==1?wC(Y):TC(Y),q=Hx(Y,Vx(m==1?bC:AC,G)),K=Xx(Y,Wx(RC,G)),ne=[],he=i.legend=wn({},LC,n.legend),fe=i.cursor=wn({},BC,{drag:{y:s==2}},n.cursor),Q=he.show,ge=fe.show,ve=he.markers;he.idxs=ne,ve.width=yt(ve.width),ve.dash=yt(ve.dash),ve.stroke=yt(ve.stroke),ve.fill=yt(ve.fill);let Re,we,Xe,ot=[],He=[],dt,ut=!1,st={};if(he.live){let x=v[1]?v[1].values:null;ut=x!=null,dt=ut?x(i,1,0):{_:0};for(let b in dt)st[b]=ap}if(Q)if(Re=ji("table",UT,c),Xe=ji("tbody",null,Re),he.mount(i,Re),ut){we=ji("thead",null,Re,Xe);let x=ji("tr",null,we);ji("th",null,x);for(var jt in dt)ji("th",vx,x).textContent=jt}else Si(Re,OT),he.live&&Si(Re,FT);let Vt={show:!0},gn={show:!1};function Ut(x,b){if(b==0&&(ut||!he.live||s==2))return $o;let P=[],D=ji("tr",BT,Xe,Xe.childNodes[b]);Si(D,x.class),x.show||Si(D,Vr);let H=ji("th",null,D);if(ve.show){let pe=Li(kT,H);if(b>0){let Se=ve.width(i,b);Se&&(pe.style.border=Se+"px "+ve.dash(i,b)+" "+ve.stroke(i,b)),pe.style.background=ve.fill(i,b)}}let J=Li(vx,H);x.label instanceof HTMLElement?J.appendChild(x.label):J.textContent=x.label,b>0&&(ve.show||(J.style.color=x.width>0?ve.stroke(i,b):ve.fill(i,b)),Mt("click",H,pe=>{if(fe._lock)return;Ke(pe);let Se=v.indexOf(x);if((pe.ctrlKey||pe.metaKey)!=he.isolate){let Ue=v.some((Fe,Be)=>Be>0&&Be!=Se&&Fe.show);v.forEach((Fe,Be)=>{Be>0&&ss(Be,Ue?Be==Se?Vt:gn:Vt,!0,Sn.setSeries)})}else ss(Se,{show:!x.show},!0,Sn.setSeries)},!1),Qe&&Mt(bx,H,pe=>{fe._lock||(Ke(pe),ss(v.indexOf(x),so,!0,Sn.setSeries))},!1));for(var oe in dt){let pe=ji("td",zT,D);pe.textContent="--",P.push(pe)}return[D,P]}let In=new Map;function Mt(x,b,P,D=!0){let H=In.get(b)||{},J=fe.bind[x](i,b,P,D);J&&(Hr(x,b,H[x]=J),In.set(b,H))}function En(x,b,P){let D=In.get(b)||{};for(let H in D)(x==null||H==x)&&(Qd(H,b,D[H]),delete D[H]);x==null&&In.delete(b)}let nn=0,_n=0,O=0,Ie=0,Ze=0,at=0,Ee=Ze,Ot=at,Ve=O,$e=Ie,R=0,M=0,X=0,ue=0;i.bbox={};let re=!1,xe=!1,ye=!1,ee=!1,ie=!1,me=!1;function F(x,b,P){(P||x!=i.width||b!=i.height)&&se(x,b),ht(!1),ye=!0,xe=!0,Gn()}function se(x,b){i.width=nn=O=x,i.height=_n=Ie=b,Ze=at=0,Me(),We();let P=i.bbox;R=P.left=zr(Ze*Tt,.5),M=P.top=zr(at*Tt,.5),X=P.width=zr(O*Tt,.5),ue=P.height=zr(Ie*Tt,.5)}let te=3;function Ae(){let x=!1,b=0;for(;!x;){b++;let P=Kr(b),D=is(b);x=b==te||P&&D,x||(se(i.width,i.height),xe=!0)}}function _e({width:x,height:b}){F(x,b)}i.setSize=_e;function Me(){let x=!1,b=!1,P=!1,D=!1;T.forEach((H,J)=>{if(H.show&&H._show){let{side:oe,_size:pe}=H,Se=oe%2,Ue=H.label!=null?H.labelSize:0,Fe=pe+Ue;Fe>0&&(Se?(O-=Fe,oe==3?(Ze+=Fe,D=!0):P=!0):(Ie-=Fe,oe==0?(at+=Fe,x=!0):b=!0))}}),ts[0]=x,ts[1]=P,ts[2]=b,ts[3]=D,O-=Fi[1]+Fi[3],Ze+=Fi[3],Ie-=Fi[2]+Fi[0],at+=Fi[0]}function We(){let x=Ze+O,b=at+Ie,P=Ze,D=at;function H(J,oe){switch(J){case 1:return x+=oe,x-oe;case 2:return b+=oe,b-oe;case 3:return P-=oe,P+oe;case 0:return D-=oe,D+oe}}T.forEach((J,oe)=>{if(J.show&&J._show){let pe=J.side;J._pos=H(pe,J._size),J.label!=null&&(J._lpos=H(pe,J.labelSize))}})}if(fe.dataIdx==null){let x=fe.hover,b=x.skip=new Set(x.skip??[]);b.add(void 0);let P=x.prox=yt(x.prox),D=x.bias??=0;fe.dataIdx=(H,J,oe,pe)=>{if(J==0)return oe;let Se=oe,Ue=P(H,J,oe,pe)??Bt,Fe=Ue>=0&&Ue<Bt,Be=I.ori==0?O:Ie,rt=fe.left,Et=e[0],bt=e[J];if(b.has(bt[oe])){Se=null;let gt=null,je=null,qe;if(D==0||D==-1)for(qe=oe;gt==null&&qe-- >0;)b.has(bt[qe])||(gt=qe);if(D==0||D==1)for(qe=oe;je==null&&qe++<bt.length;)b.has(bt[qe])||(je=qe);if(gt!=null||je!=null)if(Fe){let $t=gt==null?-1/0:W(Et[gt],I,Be,0),on=je==null?1/0:W(Et[je],I,Be,0),Un=rt-$t,Ft=on-rt;Un<=Ft?Un<=Ue&&(Se=gt):Ft<=Ue&&(Se=je)}else Se=je==null?gt:gt==null?je:oe-gt<=je-oe?gt:je}else Fe&&Pn(rt-W(Et[oe],I,Be,0))>Ue&&(Se=null);return Se}}let Ke=x=>{fe.event=x};fe.idxs=ne,fe._lock=!1;let ce=fe.points;ce.show=yt(ce.show),ce.size=yt(ce.size),ce.stroke=yt(ce.stroke),ce.width=yt(ce.width),ce.fill=yt(ce.fill);let ke=i.focus=wn({},n.focus||{alpha:.3},fe.focus),Qe=ke.prox>=0,Pe=Qe&&ce.one,lt=[],Xt=[],$n=[];function sa(x,b){let P=ce.show(i,b);if(P instanceof HTMLElement)return Si(P,DT),Si(P,x.class),ms(P,-10,-10,O,Ie),g.insertBefore(P,lt[b]),P}function Zr(x,b){if(s==1||b>0){let P=s==1&&S[x.scale].time,D=x.value;x.value=P?Bx(D)?Xx(Y,Wx(D,G)):D||K:D||$C,x.label=x.label||(P?zC:kC)}if(Pe||b>0){x.width=x.width==null?1:x.width,x.paths=x.paths||lR||KT,x.fillTo=yt(x.fillTo||QC),x.pxAlign=+wt(x.pxAlign,y),x.pxRound=ev(x.pxAlign),x.stroke=yt(x.stroke||null),x.fill=yt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=ZC(si(1,x.width),1),D=x.points=wn({},{size:P,width:si(1,P*.2),stroke:x.stroke,space:P*2,paths:cR,_stroke:null,_fill:null},x.points);D.show=yt(D.show),D.filter=yt(D.filter),D.fill=yt(D.fill),D.stroke=yt(D.stroke),D.paths=yt(D.paths),D.pxAlign=x.pxAlign}if(Q){let P=Ut(x,b);ot.splice(b,0,P[0]),He.splice(b,0,P[1]),he.values.push(null)}if(ge){ne.splice(b,0,null);let P=null;Pe?b==0&&(P=sa(x,b)):b>0&&(P=sa(x,b)),lt.splice(b,0,P),Xt.splice(b,0,0),$n.splice(b,0,0)}Dn("addSeries",b)}function Dh(x,b){b=b??v.length,x=s==1?rp(x,b,Yx,Kx):rp(x,b,{},jx),v.splice(b,0,x),Zr(v[b],b)}i.addSeries=Dh;function zl(x){if(v.splice(x,1),Q){he.values.splice(x,1),He.splice(x,1);let b=ot.splice(x,1)[0];En(null,b.firstChild),b.remove()}ge&&(ne.splice(x,1),lt.splice(x,1)[0].remove(),Xt.splice(x,1),$n.splice(x,1)),Dn("delSeries",x)}i.delSeries=zl;let ts=[!1,!1,!1,!1];function _s(x,b){if(x._show=x.show,x.show){let P=x.side%2,D=S[x.scale];D==null&&(x.scale=P?v[1].scale:A,D=S[x.scale]);let H=D.time;x.size=yt(x.size),x.space=yt(x.space),x.rotate=yt(x.rotate),dr(x.incrs)&&x.incrs.forEach(oe=>{!pr.has(oe)&&pr.set(oe,dv(oe))}),x.incrs=yt(x.incrs||(D.distr==2?yC:H?m==1?MC:EC:Gr)),x.splits=yt(x.splits||(H&&D.distr==1?ae:D.distr==3?tp:D.distr==4?HC:VC)),x.stroke=yt(x.stroke),x.grid.stroke=yt(x.grid.stroke),x.ticks.stroke=yt(x.ticks.stroke),x.border.stroke=yt(x.border.stroke);let J=x.values;x.values=dr(J)&&!dr(J[0])?yt(J):H?dr(J)?Hx(Y,Vx(J,G)):Bx(J)?CC(Y,J):J||q:J||GC,x.filter=yt(x.filter||(D.distr>=3&&D.log==10?qC:D.distr==3&&D.log==2?YC:hv)),x.font=sv(x.font),x.labelFont=sv(x.labelFont),x._size=x.size(i,null,b,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(ts[b]=!0,x._el=Li(PT,h))}}function xs(x,b,P,D){let[H,J,oe,pe]=P,Se=b%2,Ue=0;return Se==0&&(pe||J)&&(Ue=b==0&&!H||b==2&&!oe?Rn(qx.size/3):0),Se==1&&(H||oe)&&(Ue=b==1&&!J||b==3&&!pe?Rn(Zx.size/2):0),Ue}let ra=i.padding=(n.padding||[xs,xs,xs,xs]).map(x=>yt(wt(x,xs))),Fi=i._padding=ra.map((x,b)=>x(i,b,ts,0)),sn,hn=null,fn=null,ns=s==1?v[0].idxs:null,hi=null,Vs=!1;function oa(x,b){if(e=x??[],i.data=i._data=e,s==2){sn=0;for(let P=1;P<v.length;P++)sn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),hi=e[0],sn=hi.length;let P=e;if(k==2){P=e.slice();let D=P[0]=Array(sn);for(let H=0;H<sn;H++)D[H]=H}i._data=e=P}if(ht(!0),Dn("setData"),k==2&&(ye=!0),b!==!1){let P=I;P.auto(i,Vs)?aa():Xs(A,P.min,P.max),ee=ee||fe.left>=0,me=!0,Gn()}}i.setData=oa;function aa(){Vs=!0;let x,b;s==1&&(sn>0?(hn=ns[0]=0,fn=ns[1]=sn-1,x=e[0][hn],b=e[0][fn],k==2?(x=hn,b=fn):x==b&&(k==3?[x,b]=ph(x,x,I.log,!1):k==4?[x,b]=cp(x,x,I.log,!1):I.time?b=x+Rn(86400/m):[x,b]=hh(x,b,up,!0))):(hn=ns[0]=x=null,fn=ns[1]=b=null)),Xs(A,x,b)}let Jr,Hs,jr,E,z,j,$,Z,Te,Le;function Ce(x,b,P,D,H,J){x??=Sx,P??=fp,D??="butt",H??=Sx,J??="round",x!=Jr&&(f.strokeStyle=Jr=x),H!=Hs&&(f.fillStyle=Hs=H),b!=jr&&(f.lineWidth=jr=b),J!=z&&(f.lineJoin=z=J),D!=j&&(f.lineCap=j=D),P!=E&&f.setLineDash(E=P)}function Ne(x,b,P,D){b!=Hs&&(f.fillStyle=Hs=b),x!=$&&(f.font=$=x),P!=Z&&(f.textAlign=Z=P),D!=Te&&(f.textBaseline=Te=D)}function Ge(x,b,P,D,H=0){if(D.length>0&&x.auto(i,Vs)&&(b==null||b.min==null)){let J=wt(hn,0),oe=wt(fn,D.length-1),pe=P.min==null?qT(D,J,oe,H,x.distr==3):[P.min,P.max];x.min=Qi(x.min,P.min=pe[0]),x.max=si(x.max,P.max=pe[1])}}let tt={min:null,max:null};function pt(){for(let D in S){let H=S[D];V[D]==null&&(H.min==null||V[A]!=null&&H.auto(i,Vs))&&(V[D]=tt)}for(let D in S){let H=S[D];V[D]==null&&H.from!=null&&V[H.from]!=null&&(V[D]=tt)}V[A]!=null&&ht(!0);let x={};for(let D in V){let H=V[D];if(H!=null){let J=x[D]=Zo(S[D],tC);if(H.min!=null)wn(J,H);else if(D!=A||s==2)if(sn==0&&J.from==null){let oe=J.range(i,null,null,D);J.min=oe[0],J.max=oe[1]}else J.min=Bt,J.max=-Bt}}if(sn>0){v.forEach((D,H)=>{if(s==1){let J=D.scale,oe=V[J];if(oe==null)return;let pe=x[J];if(H==0){let Se=pe.range(i,pe.min,pe.max,J);pe.min=Se[0],pe.max=Se[1],hn=Ki(pe.min,e[0]),fn=Ki(pe.max,e[0]),fn-hn>1&&(e[0][hn]<pe.min&&hn++,e[0][fn]>pe.max&&fn--),D.min=hi[hn],D.max=hi[fn]}else D.show&&D.auto&&Ge(pe,oe,D,e[H],D.sorted);D.idxs[0]=hn,D.idxs[1]=fn}else if(H>0&&D.show&&D.auto){let[J,oe]=D.facets,pe=J.scale,Se=oe.scale,[Ue,Fe]=e[H],Be=x[pe],rt=x[Se];Be!=null&&Ge(Be,V[pe],J,Ue,J.sorted),rt!=null&&Ge(rt,V[Se],oe,Fe,oe.sorted),D.min=oe.min,D.max=oe.max}});for(let D in x){let H=x[D],J=V[D];if(H.from==null&&(J==null||J.min==null)){let oe=H.range(i,H.min==Bt?null:H.min,H.max==-Bt?null:H.max,D);H.min=oe[0],H.max=oe[1]}}}for(let D in x){let H=x[D];if(H.from!=null){let J=x[H.from];if(J.min==null)H.min=H.max=null;else{let oe=H.range(i,J.min,J.max,D);H.min=oe[0],H.max=oe[1]}}}let b={},P=!1;for(let D in x){let H=x[D],J=S[D];if(J.min!=H.min||J.max!=H.max){J.min=H.min,J.max=H.max;let oe=J.distr;J._min=oe==3?Bs(J.min):oe==4?qd(J.min,J.asinh):oe==100?J.fwd(J.min):J.min,J._max=oe==3?Bs(J.max):oe==4?qd(J.max,J.asinh):oe==100?J.fwd(J.max):J.max,b[D]=P=!0}}if(P){v.forEach((D,H)=>{s==2?H>0&&b.y&&(D._paths=null):b[D.scale]&&(D._paths=null)});for(let D in b)ye=!0,Dn("setScale",D);ge&&fe.left>=0&&(ee=me=!0)}for(let D in V)V[D]=null}function ze(x){let b=ep(hn-1,0,sn-1),P=ep(fn+1,0,sn-1);for(;x[b]==null&&b>0;)b--;for(;x[P]==null&&P<sn-1;)P++;return[b,P]}function mt(){if(sn>0){let x=v.some(b=>b._focus)&&Le!=ke.alpha;x&&(f.globalAlpha=Le=ke.alpha),v.forEach((b,P)=>{if(P>0&&b.show&&(tn(P,!1),tn(P,!0),b._paths==null)){let D=Le;Le!=b.alpha&&(f.globalAlpha=Le=b.alpha);let H=s==2?[0,e[P][0].length-1]:ze(e[P]);b._paths=b.paths(i,P,H[0],H[1]),Le!=D&&(f.globalAlpha=Le=D)}}),v.forEach((b,P)=>{if(P>0&&b.show){let D=Le;Le!=b.alpha&&(f.globalAlpha=Le=b.alpha),b._paths!=null&&It(P,!1);{let H=b._paths!=null?b._paths.gaps:null,J=b.points.show(i,P,hn,fn,H),oe=b.points.filter(i,P,J,H);(J||oe)&&(b.points._paths=b.points.paths(i,P,hn,fn,oe),It(P,!0))}Le!=D&&(f.globalAlpha=Le=D),Dn("drawSeries",P)}}),x&&(f.globalAlpha=Le=1)}}function tn(x,b){let P=b?v[x].points:v[x];P._stroke=P.stroke(i,x),P._fill=P.fill(i,x)}function It(x,b){let P=b?v[x].points:v[x],{stroke:D,fill:H,clip:J,flags:oe,_stroke:pe=P._stroke,_fill:Se=P._fill,_width:Ue=P.width}=P._paths;Ue=kt(Ue*Tt,3);let Fe=null,Be=Ue%2/2;b&&Se==null&&(Se=Ue>0?"#fff":pe);let rt=P.pxAlign==1&&Be>0;if(rt&&f.translate(Be,Be),!b){let Et=R-Ue/2,bt=M-Ue/2,gt=X+Ue,je=ue+Ue;Fe=new Path2D,Fe.rect(Et,bt,gt,je)}b?Oe(pe,Ue,P.dash,P.cap,Se,D,H,oe,J):Lt(x,pe,Ue,P.dash,P.cap,Se,D,H,oe,Fe,J),rt&&f.translate(-Be,-Be)}function Lt(x,b,P,D,H,J,oe,pe,Se,Ue,Fe){let Be=!1;Se!=0&&C.forEach((rt,Et)=>{if(rt.series[0]==x){let bt=v[rt.series[1]],gt=e[rt.series[1]],je=(bt._paths||Cl).band;dr(je)&&(je=rt.dir==1?je[0]:je[1]);let qe,$t=null;bt.show&&je&&$T(gt,hn,fn)?($t=rt.fill(i,Et)||J,qe=bt._paths.clip):je=null,Oe(b,P,D,H,$t,oe,pe,Se,Ue,Fe,qe,je),Be=!0}}),Be||Oe(b,P,D,H,J,oe,pe,Se,Ue,Fe)}let An=Jo|ip;function Oe(x,b,P,D,H,J,oe,pe,Se,Ue,Fe,Be){Ce(x,b,P,D,H),(Se||Ue||Be)&&(f.save(),Se&&f.clip(Se),Ue&&f.clip(Ue)),Be?(pe&An)==An?(f.clip(Be),Fe&&f.clip(Fe),_t(H,oe),xn(x,J,b)):pe&ip?(_t(H,oe),f.clip(Be),xn(x,J,b)):pe&Jo&&(f.save(),f.clip(Be),Fe&&f.clip(Fe),_t(H,oe),f.restore(),xn(x,J,b)):(_t(H,oe),xn(x,J,b)),(Se||Ue||Be)&&f.restore()}function xn(x,b,P){P>0&&(b instanceof Map?b.forEach((D,H)=>{f.strokeStyle=Jr=H,f.stroke(D)}):b!=null&&x&&f.stroke(b))}function _t(x,b){b instanceof Map?b.forEach((P,D)=>{f.fillStyle=Hs=D,f.fill(P)}):b!=null&&x&&f.fill(b)}function vs(x,b,P,D){let H=T[x],J;if(D<=0)J=[0,0];else{let oe=H._space=H.space(i,x,b,P,D),pe=H._incrs=H.incrs(i,x,b,P,D,oe);J=mR(b,P,pe,D,oe)}return H._found=J}function vn(x,b,P,D,H,J,oe,pe,Se,Ue){let Fe=oe%2/2;y==1&&f.translate(Fe,Fe),Ce(pe,oe,Se,Ue,pe),f.beginPath();let Be,rt,Et,bt,gt=H+(D==0||D==3?-J:J);P==0?(rt=H,bt=gt):(Be=H,Et=gt);for(let je=0;je<x.length;je++)b[je]!=null&&(P==0?Be=Et=x[je]:rt=bt=x[je],f.moveTo(Be,rt),f.lineTo(Et,bt));f.stroke(),y==1&&f.translate(-Fe,-Fe)}function Kr(x){let b=!0;return T.forEach((P,D)=>{if(!P.show)return;let H=S[P.scale];if(H.min==null){P._show&&(b=!1,P._show=!1,ht(!1));return}else P._show||(b=!1,P._show=!0,ht(!1));let J=P.side,oe=J%2,{min:pe,max:Se}=H,[Ue,Fe]=vs(D,pe,Se,oe==0?O:Ie);if(Fe==0)return;let Be=H.distr==2,rt=P._splits=P.splits(i,D,pe,Se,Ue,Fe,Be),Et=H.distr==2?rt.map(qe=>hi[qe]):rt,bt=H.distr==2?hi[rt[1]]-hi[rt[0]]:Ue,gt=P._values=P.values(i,P.filter(i,Et,D,Fe,bt),D,Fe,bt);P._rotate=J==2?P.rotate(i,gt,D,Fe):0;let je=P._size;P._size=Ni(P.size(i,gt,D,x)),je!=null&&P._size!=je&&(b=!1)}),b}function is(x){let b=!0;return ra.forEach((P,D)=>{let H=P(i,D,ts,x);H!=Fi[D]&&(b=!1),Fi[D]=H}),b}function ys(){for(let x=0;x<T.length;x++){let b=T[x];if(!b.show||!b._show)continue;let P=b.side,D=P%2,H,J,oe=b.stroke(i,x),pe=P==0||P==3?-1:1,[Se,Ue]=b._found;if(b.label!=null){let jn=b.labelGap*pe,pi=Rn((b._lpos+jn)*Tt);Ne(b.labelFont[0],oe,"center",P==2?"top":yx),f.save(),D==1?(H=J=0,f.translate(pi,Rn(M+ue/2)),f.rotate((P==3?-ch:ch)/2)):(H=Rn(R+X/2),J=pi);let vr=cv(b.label)?b.label(i,x,Se,Ue):b.label;f.fillText(vr,H,J),f.restore()}if(Ue==0)continue;let Fe=S[b.scale],Be=D==0?X:ue,rt=D==0?R:M,Et=b._splits,bt=Fe.distr==2?Et.map(jn=>hi[jn]):Et,gt=Fe.distr==2?hi[Et[1]]-hi[Et[0]]:Se,je=b.ticks,qe=b.border,$t=je.show?je.size:0,on=Rn($t*Tt),Un=Rn((b.alignTo==2?b._size-$t-b.gap:b.gap)*Tt),Ft=b._rotate*-ch/180,an=d(b._pos*Tt),fi=(on+Un)*pe,Jn=an+fi;J=D==0?Jn:0,H=D==1?Jn:0;let wi=b.font[0],Oi=b.align==1?Wo:b.align==2?Hd:Ft>0?Wo:Ft<0?Hd:D==0?"center":P==3?Hd:Wo,os=Ft||D==1?"middle":P==2?"top":yx;Ne(wi,oe,Oi,os);let di=b.font[1]*b.lineGap,Ei=Et.map(jn=>d(a(jn,Fe,Be,rt))),Bi=b._values;for(let jn=0;jn<Bi.length;jn++){let pi=Bi[jn];if(pi!=null){D==0?H=Ei[jn]:J=Ei[jn],pi=""+pi;let vr=pi.indexOf(`
`)==-1?[pi]:pi.split(/\n/gm);for(let Kn=0;Kn<vr.length;Kn++){let cm=vr[Kn];Ft?(f.save(),f.translate(H,J+Kn*di),f.rotate(Ft),f.fillText(cm,0,0),f.restore()):f.fillText(cm,H,J+Kn*di)}}}je.show&&vn(Ei,je.filter(i,bt,x,Ue,gt),D,P,an,on,kt(je.width*Tt,3),je.stroke(i,x),je.dash,je.cap);let as=b.grid;as.show&&vn(Ei,as.filter(i,bt,x,Ue,gt),D,D==0?2:1,D==0?M:R,D==0?ue:X,kt(as.width*Tt,3),as.stroke(i,x),as.dash,as.cap),qe.show&&vn([an],[1],D==0?1:0,D==0?1:2,D==1?M:R,D==1?ue:X,kt(qe.width*Tt,3),qe.stroke(i,x),qe.dash,qe.cap)}Dn("drawAxes")}function ht(x){v.forEach((b,P)=>{P>0&&(b._paths=null,x&&(s==1?(b.min=null,b.max=null):b.facets.forEach(D=>{D.min=null,D.max=null})))})}let rn=!1,Zn=!1,Nt=[];function yn(){Zn=!1;for(let x=0;x<Nt.length;x++)Dn(...Nt[x]);Nt.length=0}function Gn(){rn||(lC(Xp),rn=!0)}function Gl(x,b=!1){rn=!0,Zn=b,x(i),Xp(),b&&Nt.length>0&&queueMicrotask(yn)}i.batch=Gl;function Xp(){if(re&&(pt(),re=!1),ye&&(Ae(),ye=!1),xe){if(Jt(p,Wo,Ze),Jt(p,"top",at),Jt(p,wl,O),Jt(p,El,Ie),Jt(g,Wo,Ze),Jt(g,"top",at),Jt(g,wl,O),Jt(g,El,Ie),Jt(h,wl,nn),Jt(h,El,_n),u.width=Rn(nn*Tt),u.height=Rn(_n*Tt),T.forEach(({_el:x,_show:b,_size:P,_pos:D,side:H})=>{if(x!=null)if(b){let J=H===3||H===0?P:0,oe=H%2==1;Jt(x,oe?"left":"top",D-J),Jt(x,oe?"width":"height",P),Jt(x,oe?"top":"left",oe?at:Ze),Jt(x,oe?"height":"width",oe?Ie:O),Kd(x,Vr)}else Si(x,Vr)}),Jr=Hs=jr=z=j=$=Z=Te=E=null,Le=1,ua(!0),Ze!=Ee||at!=Ot||O!=Ve||Ie!=$e){ht(!1);let x=O/Ve,b=Ie/$e;if(ge&&!ee&&fe.left>=0){fe.left*=x,fe.top*=b,Qr&&ms(Qr,Rn(fe.left),0,O,Ie),eo&&ms(eo,0,Rn(fe.top),O,Ie);for(let P=0;P<lt.length;P++){let D=lt[P];D!=null&&(Xt[P]*=x,$n[P]*=b,ms(D,Ni(Xt[P]),Ni($n[P]),O,Ie))}}if(Yt.show&&!ie&&Yt.left>=0&&Yt.width>0){Yt.left*=x,Yt.width*=x,Yt.top*=b,Yt.height*=b;for(let P in zh)Jt(io,P,Yt[P])}Ee=Ze,Ot=at,Ve=O,$e=Ie}Dn("setSize"),xe=!1}nn>0&&_n>0&&(f.clearRect(0,0,u.width,u.height),Dn("drawClear"),w.forEach(x=>x()),Dn("draw")),Yt.show&&ie&&(Vl(Yt),ie=!1),ge&&ee&&(xr(null,!0,!1),ee=!1),he.show&&he.live&&me&&(Bh(),me=!1),l||(l=!0,i.status=1,Dn("ready")),Vs=!1,rn=!1}i.redraw=(x,b)=>{ye=b||!1,x!==!1?Xs(A,I.min,I.max):Gn()};function Uh(x,b){let P=S[x];if(P.from==null){if(sn==0){let D=P.range(i,b.min,b.max,x);b.min=D[0],b.max=D[1]}if(b.min>b.max){let D=b.min;b.min=b.max,b.max=D}if(sn>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;x==A&&P.distr==2&&sn>0&&(b.min=Ki(b.min,e[0]),b.max=Ki(b.max,e[0]),b.min==b.max&&b.max++),V[x]=b,re=!0,Gn()}}i.setScale=Uh;let Fh,Oh,Qr,eo,qp,Yp,to,no,$p,Zp,qt,Kt,Ws=!1,kn=fe.drag,Ln=kn.x,Nn=kn.y;ge&&(fe.x&&(Fh=Li(LT,g)),fe.y&&(Oh=Li(NT,g)),I.ori==0?(Qr=Fh,eo=Oh):(Qr=Oh,eo=Fh),qt=fe.left,Kt=fe.top);let Yt=i.select=wn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),io=Yt.show?Li(IT,Yt.over?g:p):null;function Vl(x,b){if(Yt.show){for(let P in x)Yt[P]=x[P],P in zh&&Jt(io,P,x[P]);b!==!1&&Dn("setSelect")}}i.setSelect=Vl;function NS(x){if(v[x].show)Q&&Kd(ot[x],Vr);else if(Q&&Si(ot[x],Vr),ge){let P=Pe?lt[0]:lt[x];P!=null&&ms(P,-10,-10,O,Ie)}}function Xs(x,b,P){Uh(x,{min:b,max:P})}function ss(x,b,P,D){b.focus!=null&&BS(x),b.show!=null&&v.forEach((H,J)=>{J>0&&(x==J||x==null)&&(H.show=b.show,NS(J),s==2?(Xs(H.facets[0].scale,null,null),Xs(H.facets[1].scale,null,null)):Xs(H.scale,null,null),Gn())}),P!==!1&&Dn("setSeries",x,b),D&&ha("setSeries",i,x,b)}i.setSeries=ss;function DS(x,b){wn(C[x],b)}function US(x,b){x.fill=yt(x.fill||null),x.dir=wt(x.dir,-1),b=b??C.length,C.splice(b,0,x)}function FS(x){x==null?C.length=0:C.splice(x,1)}i.addBand=US,i.setBand=DS,i.delBand=FS;function OS(x,b){v[x].alpha=b,ge&&lt[x]!=null&&(lt[x].style.opacity=b),Q&&ot[x]&&(ot[x].style.opacity=b)}let Ss,qs,_r,so={focus:!0};function BS(x){if(x!=_r){let b=x==null,P=ke.alpha!=1;v.forEach((D,H)=>{if(s==1||H>0){let J=b||H==0||H==x;D._focus=b?null:J,P&&OS(H,J?1:ke.alpha)}}),_r=x,P&&Gn()}}Q&&Qe&&Mt(wx,Re,x=>{fe._lock||(Ke(x),_r!=null&&ss(null,so,!0,Sn.setSeries))});function rs(x,b,P){let D=S[b];P&&(x=x/Tt-(D.ori==1?at:Ze));let H=O;D.ori==1&&(H=Ie,x=H-x),D.dir==-1&&(x=H-x);let J=D._min,oe=D._max,pe=x/H,Se=J+(oe-J)*pe,Ue=D.distr;return Ue==3?Yo(10,Se):Ue==4?JT(Se,D.asinh):Ue==100?D.bwd(Se):Se}function kS(x,b){let P=rs(x,A,b);return Ki(P,e[0],hn,fn)}i.valToIdx=x=>Ki(x,e[0]),i.posToIdx=kS,i.posToVal=rs,i.valToPos=(x,b,P)=>S[b].ori==0?r(x,S[b],P?X:O,P?R:0):o(x,S[b],P?ue:Ie,P?M:0),i.setCursor=(x,b,P)=>{qt=x.left,Kt=x.top,xr(null,b,P)};function Jp(x,b){Jt(io,Wo,Yt.left=x),Jt(io,wl,Yt.width=b)}function jp(x,b){Jt(io,"top",Yt.top=x),Jt(io,El,Yt.height=b)}let la=I.ori==0?Jp:jp,ca=I.ori==1?Jp:jp;function zS(){if(Q&&he.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&ut)continue;let b=he.values[x],P=0;for(let D in b)He[x][P++].firstChild.nodeValue=b[D]}}function Bh(x,b){if(x!=null&&(x.idxs?x.idxs.forEach((P,D)=>{ne[D]=P}):eC(x.idx)||ne.fill(x.idx),he.idx=ne[0]),Q&&he.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!ut)&&GS(P,ne[P]);zS()}me=!1,b!==!1&&Dn("setLegend")}i.setLegend=Bh;function GS(x,b){let P=v[x],D=x==0&&k==2?hi:e[x],H;ut?H=P.values(i,x,b)??st:(H=P.value(i,b==null?null:D[b],x,b),H=H==null?st:{_:H}),he.values[x]=H}function xr(x,b,P){$p=qt,Zp=Kt,[qt,Kt]=fe.move(i,qt,Kt),fe.left=qt,fe.top=Kt,ge&&(Qr&&ms(Qr,Rn(qt),0,O,Ie),eo&&ms(eo,0,Rn(Kt),O,Ie));let D,H=hn>fn;Ss=Bt,qs=null;let J=I.ori==0?O:Ie,oe=I.ori==1?O:Ie;if(qt<0||sn==0||H){D=fe.idx=null;for(let pe=0;pe<v.length;pe++){let Se=lt[pe];Se!=null&&ms(Se,-10,-10,O,Ie)}Qe&&ss(null,so,!0,x==null&&Sn.setSeries),he.live&&(ne.fill(D),me=!0)}else{let pe,Se,Ue;s==1&&(pe=I.ori==0?qt:Kt,Se=rs(pe,A),D=fe.idx=Ki(Se,e[0],hn,fn),Ue=W(e[0][D],I,J,0));let Fe=-10,Be=-10,rt=0,Et=0,bt=!0,gt="",je="";for(let qe=s==2?1:0;qe<v.length;qe++){let $t=v[qe],on=ne[qe],Un=on==null?null:s==1?e[qe][on]:e[qe][1][on],Ft=fe.dataIdx(i,qe,D,Se),an=Ft==null?null:s==1?e[qe][Ft]:e[qe][1][Ft];if(me=me||an!=Un||Ft!=on,ne[qe]=Ft,qe>0&&$t.show){let fi=Ft==null?-10:Ft==D?Ue:W(s==1?e[0][Ft]:e[qe][0][Ft],I,J,0),Jn=an==null?-10:N(an,s==1?S[$t.scale]:S[$t.facets[1].scale],oe,0);if(Qe&&an!=null){let wi=I.ori==1?qt:Kt,Oi=Pn(ke.dist(i,qe,Ft,Jn,wi));if(Oi<Ss){let os=ke.bias;if(os!=0){let di=rs(wi,$t.scale),Ei=an>=0?1:-1,Bi=di>=0?1:-1;Bi==Ei&&(Bi==1?os==1?an>=di:an<=di:os==1?an<=di:an>=di)&&(Ss=Oi,qs=qe)}else Ss=Oi,qs=qe}}if(me||Pe){let wi,Oi;I.ori==0?(wi=fi,Oi=Jn):(wi=Jn,Oi=fi);let os,di,Ei,Bi,as,jn,pi=!0,vr=ce.bbox;if(vr!=null){pi=!1;let Kn=vr(i,qe);Ei=Kn.left,Bi=Kn.top,os=Kn.width,di=Kn.height}else Ei=wi,Bi=Oi,os=di=ce.size(i,qe);if(jn=ce.fill(i,qe),as=ce.stroke(i,qe),Pe)qe==qs&&Ss<=ke.prox&&(Fe=Ei,Be=Bi,rt=os,Et=di,bt=pi,gt=jn,je=as);else{let Kn=lt[qe];Kn!=null&&(Xt[qe]=Ei,$n[qe]=Bi,Ix(Kn,os,di,pi),Rx(Kn,jn,as),ms(Kn,Ni(Ei),Ni(Bi),O,Ie))}}}}if(Pe){let qe=ke.prox,$t=_r==null?Ss<=qe:Ss>qe||qs!=_r;if(me||$t){let on=lt[0];on!=null&&(Xt[0]=Fe,$n[0]=Be,Ix(on,rt,Et,bt),Rx(on,gt,je),ms(on,Ni(Fe),Ni(Be),O,Ie))}}}if(Yt.show&&Ws)if(x!=null){let[pe,Se]=Sn.scales,[Ue,Fe]=Sn.match,[Be,rt]=x.cursor.sync.scales,Et=x.cursor.drag;if(Ln=Et._x,Nn=Et._y,Ln||Nn){let{left:bt,top:gt,width:je,height:qe}=x.select,$t=x.scales[Be].ori,on=x.posToVal,Un,Ft,an,fi,Jn,wi=pe!=null&&Ue(pe,Be),Oi=Se!=null&&Fe(Se,rt);wi&&Ln?($t==0?(Un=bt,Ft=je):(Un=gt,Ft=qe),an=S[pe],fi=W(on(Un,Be),an,J,0),Jn=W(on(Un+Ft,Be),an,J,0),la(Qi(fi,Jn),Pn(Jn-fi))):la(0,J),Oi&&Nn?($t==1?(Un=bt,Ft=je):(Un=gt,Ft=qe),an=S[Se],fi=N(on(Un,rt),an,oe,0),Jn=N(on(Un+Ft,rt),an,oe,0),ca(Qi(fi,Jn),Pn(Jn-fi))):ca(0,oe)}else Gh()}else{let pe=Pn($p-qp),Se=Pn(Zp-Yp);if(I.ori==1){let rt=pe;pe=Se,Se=rt}Ln=kn.x&&pe>=kn.dist,Nn=kn.y&&Se>=kn.dist;let Ue=kn.uni;Ue!=null?Ln&&Nn&&(Ln=pe>=Ue,Nn=Se>=Ue,!Ln&&!Nn&&(Se>pe?Nn=!0:Ln=!0)):kn.x&&kn.y&&(Ln||Nn)&&(Ln=Nn=!0);let Fe,Be;Ln&&(I.ori==0?(Fe=to,Be=qt):(Fe=no,Be=Kt),la(Qi(Fe,Be),Pn(Be-Fe)),Nn||ca(0,oe)),Nn&&(I.ori==1?(Fe=to,Be=qt):(Fe=no,Be=Kt),ca(Qi(Fe,Be),Pn(Be-Fe)),Ln||la(0,J)),!Ln&&!Nn&&(la(0,0),ca(0,0))}if(kn._x=Ln,kn._y=Nn,x==null){if(P){if(lm!=null){let[pe,Se]=Sn.scales;Sn.values[0]=pe!=null?rs(I.ori==0?qt:Kt,pe):null,Sn.values[1]=Se!=null?rs(I.ori==1?qt:Kt,Se):null}ha(Wd,i,qt,Kt,O,Ie,D)}if(Qe){let pe=P&&Sn.setSeries,Se=ke.prox;_r==null?Ss<=Se&&ss(qs,so,!0,pe):Ss>Se?ss(null,so,!0,pe):qs!=_r&&ss(qs,so,!0,pe)}}me&&(he.idx=D,Bh()),b!==!1&&Dn("setCursor")}let Ys=null;Object.defineProperty(i,"rect",{get(){return Ys==null&&ua(!1),Ys}});function ua(x=!1){x?Ys=null:(Ys=g.getBoundingClientRect(),Dn("syncRect",Ys))}function Kp(x,b,P,D,H,J,oe){fe._lock||Ws&&x!=null&&x.movementX==0&&x.movementY==0||(kh(x,b,P,D,H,J,oe,!1,x!=null),x!=null?xr(null,!0,!0):xr(b,!0,!1))}function kh(x,b,P,D,H,J,oe,pe,Se){if(Ys==null&&ua(!1),Ke(x),x!=null)P=x.clientX-Ys.left,D=x.clientY-Ys.top;else{if(P<0||D<0){qt=-10,Kt=-10;return}let[Ue,Fe]=Sn.scales,Be=b.cursor.sync,[rt,Et]=Be.values,[bt,gt]=Be.scales,[je,qe]=Sn.match,$t=b.axes[0].side%2==1,on=I.ori==0?O:Ie,Un=I.ori==1?O:Ie,Ft=$t?J:H,an=$t?H:J,fi=$t?D:P,Jn=$t?P:D;if(bt!=null?P=je(Ue,bt)?a(rt,S[Ue],on,0):-10:P=on*(fi/Ft),gt!=null?D=qe(Fe,gt)?a(Et,S[Fe],Un,0):-10:D=Un*(Jn/an),I.ori==1){let wi=P;P=D,D=wi}}Se&&(b==null||b.cursor.event.type==Wd)&&((P<=1||P>=O-1)&&(P=zr(P,O)),(D<=1||D>=Ie-1)&&(D=zr(D,Ie))),pe?(qp=P,Yp=D,[to,no]=fe.move(i,P,D)):(qt=P,Kt=D)}let zh={width:0,height:0,left:0,top:0};function Gh(){Vl(zh,!1)}let Qp,em,tm,nm;function im(x,b,P,D,H,J,oe){Ws=!0,Ln=Nn=kn._x=kn._y=!1,kh(x,b,P,D,H,J,oe,!0,!1),x!=null&&(Mt(Xd,Jd,sm,!1),ha(Mx,i,to,no,O,Ie,null));let{left:pe,top:Se,width:Ue,height:Fe}=Yt;Qp=pe,em=Se,tm=Ue,nm=Fe}function sm(x,b,P,D,H,J,oe){Ws=kn._x=kn._y=!1,kh(x,b,P,D,H,J,oe,!1,!0);let{left:pe,top:Se,width:Ue,height:Fe}=Yt,Be=Ue>0||Fe>0,rt=Qp!=pe||em!=Se||tm!=Ue||nm!=Fe;if(Be&&rt&&Vl(Yt),kn.setScale&&Be&&rt){let Et=pe,bt=Ue,gt=Se,je=Fe;if(I.ori==1&&(Et=Se,bt=Fe,gt=pe,je=Ue),Ln&&Xs(A,rs(Et,A),rs(Et+bt,A)),Nn)for(let qe in S){let $t=S[qe];qe!=A&&$t.from==null&&$t.min!=Bt&&Xs(qe,rs(gt+je,qe),rs(gt,qe))}Gh()}else fe.lock&&(fe._lock=!fe._lock,xr(b,!0,x!=null));x!=null&&(En(Xd,Jd),ha(Xd,i,qt,Kt,O,Ie,null))}function VS(x,b,P,D,H,J,oe){if(fe._lock)return;Ke(x);let pe=Ws;if(Ws){let Se=!0,Ue=!0,Fe=10,Be,rt;I.ori==0?(Be=Ln,rt=Nn):(Be=Nn,rt=Ln),Be&&rt&&(Se=qt<=Fe||qt>=O-Fe,Ue=Kt<=Fe||Kt>=Ie-Fe),Be&&Se&&(qt=qt<to?0:O),rt&&Ue&&(Kt=Kt<no?0:Ie),xr(null,!0,!0),Ws=!1}qt=-10,Kt=-10,ne.fill(null),xr(null,!0,!0),pe&&(Ws=pe)}function rm(x,b,P,D,H,J,oe){fe._lock||(Ke(x),aa(),Gh(),x!=null&&ha(Ex,i,qt,Kt,O,Ie,null))}function om(){T.forEach(gR),F(i.width,i.height,!0)}Hr(uh,qo,om);let ro={};ro.mousedown=im,ro.mousemove=Kp,ro.mouseup=sm,ro.dblclick=rm,ro.setSeries=(x,b,P,D)=>{let H=Sn.match[2];P=H(i,b,P),P!=-1&&ss(P,D,!0,!1)},ge&&(Mt(Mx,g,im),Mt(Wd,g,Kp),Mt(bx,g,x=>{Ke(x),ua(!1)}),Mt(wx,g,VS),Mt(Ex,g,rm),sp.add(i),i.syncRect=ua);let Hl=i.hooks=n.hooks||{};function Dn(x,b,P){Zn?Nt.push([x,b,P]):x in Hl&&Hl[x].forEach(D=>{D.call(null,i,b,P)})}(n.plugins||[]).forEach(x=>{for(let b in x.hooks)Hl[b]=(Hl[b]||[]).concat(x.hooks[b])});let am=(x,b,P)=>P,Sn=wn({key:null,setSeries:!1,filters:{pub:Fx,sub:Fx},scales:[A,v[1]?v[1].scale:null],match:[Ox,Ox,am],values:[null,null]},fe.sync);Sn.match.length==2&&Sn.match.push(am),fe.sync=Sn;let lm=Sn.key,Vh=Nv(lm);function ha(x,b,P,D,H,J,oe){Sn.filters.pub(x,b,P,D,H,J,oe)&&Vh.pub(x,b,P,D,H,J,oe)}Vh.sub(i);function HS(x,b,P,D,H,J,oe){Sn.filters.sub(x,b,P,D,H,J,oe)&&ro[x](null,b,P,D,H,J,oe)}i.pub=HS;function WS(){Vh.unsub(i),sp.delete(i),In.clear(),Qd(uh,qo,om),c.remove(),Re?.remove(),Dn("destroy")}i.destroy=WS;function Hh(){Dn("init",n,e),oa(e||n.data,!1),V[A]?Uh(A,V[A]):aa(),ie=Yt.show&&(Yt.width>0||Yt.height>0),ee=me=!0,F(n.width,n.height)}return v.forEach(Zr),T.forEach(_s),t?t instanceof HTMLElement?(t.appendChild(c),Hh()):t(i,Hh):Hh(),i}zn.assign=wn;zn.fmtNum=hp;zn.rangeNum=hh;zn.rangeLog=ph;zn.rangeAsinh=cp;zn.orient=Xr;zn.pxRatio=Tt;zn.join=aC;zn.fmtDate=dp,zn.tzDate=xC;zn.sync=Nv;{zn.addGap=eR,zn.clipGaps=_h;let n=zn.paths={points:kv};n.linear=Gv,n.stepped=iR,n.bars=sR,n.spline=oR}function yp(n,e=10,t=2500){return{step:e/t,bins:t,used:0,last:-1,base:null,times:new Float64Array(t),values:Object.fromEntries(n.map(s=>[s,new Float64Array(t).fill(NaN)]))}}function Sh(n){n.used=0,n.last=-1,n.base=null}function Sp(n,e,t){if(!Number.isFinite(e))return;n.base===null&&(n.base=e);let i=Math.floor((e-n.base)/n.step);if(i<n.last&&(Sh(n),n.base=e,i=0),i!==n.last){n.used===n.bins&&_R(n),n.times[n.used]=e;for(let o of Object.values(n.values))o[n.used]=NaN;n.used+=1,n.last=i}let r=n.used-1;for(let[o,a]of Object.entries(t)){let l=n.values[o];!l||!Number.isFinite(a)||Math.abs(l[r])>=Math.abs(a)||(l[r]=a)}}function _R(n){let e=n.bins>>3;n.times.copyWithin(0,e);for(let t of Object.values(n.values))t.copyWithin(0,e);n.used-=e}function Mp(n,e){return[n.times.subarray(0,n.used),...e.map(t=>{let i=new Array(n.used);for(let s=0;s<n.used;s++)i[s]=Number.isNaN(n.values[t][s])?null:n.values[t][s];return i})]}function Xv(n,e){let t=Object.keys(e),i=[["time [s]",...t.map(s=>e[s])].join(",")];for(let s=0;s<n.used;s++){let r=t.map(o=>Number.isFinite(n.values[o][s])?n.values[o][s]:"");i.push([n.times[s].toFixed(4),...r].join(","))}return i.join(`
`)+`
`}var ea=10,bp=56,xR=45,Yv=["force","force_x","force_y","force_z","torque","torque_x","torque_y","torque_z","penetration","stretch","energy","model_age","step_cpu","wake_late"],vR=["haptic_rate","contact_rate"],qv=["x","y","z"],yR=[{id:"force",title:"Force on the hand",unit:"N",least:.001,lines:["force","force_x","force_y","force_z"],names:["size",...qv],colours:["force","x","y","z"]},{id:"torque",title:"Torque on the hand",unit:"N m",least:1e-6,lines:["torque","torque_x","torque_y","torque_z"],names:["size",...qv],colours:["torque","x","y","z"]},{id:"penetration",title:"Penetration, below 0: gap",unit:"m",least:1e-9,lines:["penetration"],names:["depth"],colours:["contact"]},{id:"stretch",title:"Coupling stretch",unit:"m",least:1e-9,lines:["stretch"],names:["stretch"],colours:["hand"]},{id:"rates",title:"Contact and haptic rate",unit:"Hz",least:1,lines:["contact_rate","haptic_rate"],names:["contact","haptic"],colours:["contact","held"],slow:!0},{id:"age",title:"Age of the contact model",unit:"s",least:1e-6,lines:["model_age"],names:["age"],colours:["muted"]},{id:"energy",title:"Energy put in by the hand",unit:"J",least:1e-9,lines:["energy"],names:["energy"],colours:["torque"]}];function $v(n,e,t){let i={pick:t,pointed:null,parent:n,fast:yp(Yv,ea),slow:yp(vR,ea,600),plots:[],rows:0,now:0,marks:[],theme:null,floors:{Hz:1e3,s:.001},rested:0},s=Object.assign(document.createElement("div"),{className:"plots-head"});i.moment=Object.assign(document.createElement("span"),{className:"grow moment"}),s.append(i.moment);for(let[r,o,a]of e){let l=Object.assign(document.createElement("button"),{type:"button",textContent:r,title:o});l.setAttribute("aria-label",`${r}: ${o}`),l.addEventListener("click",a),s.append(l)}n.append(s),n.addEventListener("keydown",r=>AR(i,r));for(let r of yR){let o=document.createElement("figure");o.className="plot";let a=document.createElement("figcaption"),l=document.createElement("output"),c=document.createElement("span");c.className="keys",a.append(Object.assign(document.createElement("span"),{textContent:r.title,className:"plot-title"}),c,l);let u=document.createElement("div");u.className="plot-area",o.append(a,u),n.append(o),i.plots.push({spec:r,box:o,area:u,keys:c,value:l,chart:null})}return i}function Mh(n){n.theme=$u();for(let e of n.plots){e.chart?.destroy(),e.keys.replaceChildren(...e.spec.lines.length>1?e.spec.names.map((i,s)=>{let r=Object.assign(document.createElement("i"),{textContent:i});return r.style.setProperty("--tone",Rt(e.spec.colours[s])),r}):[]);let t=e.area.clientWidth||300;e.chart=new zn(SR(n,e,t),Mp(Zv(n,e),e.spec.lines),e.area),e.chart.over.addEventListener("click",()=>{n.pointed&&n.pick(n.pointed.time)})}}var Zv=(n,{spec:e})=>e.slow?n.slow:n.fast;function SR(n,{spec:e},t){let i={stroke:Rt("grid"),width:1};return{width:t,height:bp,legend:{show:!1},cursor:{sync:{key:"thigma"},points:{size:5},drag:{x:!1,y:!1}},padding:[6,6,0,0],scales:{x:{time:!1,range:()=>[n.now-ea,n.now]},y:{range:(r,o,a)=>MR(o,a,Math.max(e.least,n.floors[e.unit]??0))}},axes:[{show:!0,size:4,grid:i,ticks:{show:!1},values:()=>[],space:40},{size:52,grid:i,ticks:{show:!1},space:12,gap:4,font:"10px system-ui, sans-serif",stroke:Rt("muted"),values:(r,o)=>bR(o,e)}],series:[{},...e.lines.map((r,o)=>({stroke:Rt(e.colours[o]),width:o===0||e.slow?1.6:.8,alpha:o===0||e.slow?1:.75,points:{show:!1},spanGaps:!1,fill:o===0&&!e.slow?`${Rt(e.colours[o])}1f`:void 0}))],hooks:{draw:[r=>wR(r,n)]}}}function MR(n,e,t){if(!Number.isFinite(n)||!Number.isFinite(e))return[0,t];let i=Math.min(0,n),s=Math.max(0,e,i+t),r=.1*(s-i);return[i<0?i-r:0,s+r]}function bR(n,e){let t=Math.max(...n.map(Math.abs)),{number:i,unit:s}=hd(t,e.unit,e.least),r=t===0?1:Number(i)/t,o=n.length>3?2:1,a=n.length-1-(n.length-1)%o;return n.map((l,c)=>{if(c%o!==0)return null;let u=Number((l*r).toPrecision(2)).toString();return c===a?`${u} ${s}`:u})}function wR(n,e){let{ctx:t,bbox:i}=n;t.save(),t.lineWidth=1,t.setLineDash([3,3]);for(let{time:s,kind:r}of e.marks){if(s<e.now-ea)continue;let o=n.valToPos(s,"x",!0);t.strokeStyle=Rt(r==="fault"?"bad":"mark"),t.beginPath(),t.moveTo(o,i.top),t.lineTo(o,i.top+i.height),t.stroke()}t.restore()}function Jv(n,e,t){n.marks.push({time:e,kind:t}),n.marks=n.marks.filter(i=>i.time>e-ea).slice(-40)}function jv(n,e,t,i){let s=e/i/10;Object.assign(n.floors,{N:s,"N m":.3*s*e,m:.25*t,J:.01*s*e})}function Kv(n,e,t){let i=Object.fromEntries(t.map((r,o)=>[r,o])),s=Yv.filter(r=>i[r]!==void 0);for(let r=0;r<e.rows;r++){let o=c=>e.values[r*e.columns+i[c]],a=Object.fromEntries(s.map(c=>[c,o(c)]));a.force=Math.hypot(a.force_x,a.force_y,a.force_z),a.torque=Math.hypot(a.torque_x,a.torque_y,a.torque_z);let l=e.time+o("t");Sp(n.fast,l,a)}n.rows+=e.rows}function Qv(n,e,t,i){Sp(n.slow,e,{haptic_rate:t,contact_rate:i})}function ey(n){Sh(n.fast),Sh(n.slow),n.marks=[]}var ER=1/40;function AR(n,e){let t={ArrowLeft:-1,ArrowRight:1}[e.key];if(!(!t&&e.key!=="Escape"&&e.key!=="Enter"||e.target!==n.parent)){if(e.key==="Enter"){n.pointed&&n.pick(n.pointed.time);return}e.preventDefault();for(let{chart:i}of n.plots){let s=i.over.clientWidth,r=i.cursor.left>=0?i.cursor.left:s,o=t?Math.max(0,Math.min(s-1,r+t*ER*s)):-10;i.setCursor({left:o,top:o<0?-10:.5*bp},!1,!1)}n.rested=0}}function TR(n){let{chart:e}=n.plots[0],{idx:t,left:i}=e.cursor;if(t==null||!(i>=0)||!(t<n.fast.used))return null;let s=r=>n.fast.values[r][t];return{time:n.fast.times[t],force:s("force"),torque:s("torque"),penetration:s("penetration"),stretch:s("stretch")}}function ty(n,e){let t=performance.now();if(t<n.rested||n.parent.hidden||n.parent.offsetParent===null)return;Object.assign(n,{now:e,pointed:TR(n)});let i=n.pointed?`At ${n.pointed.time.toFixed(2)} s, ${(e-n.pointed.time).toFixed(2)} s ago`:`The last ${ea} s; point at a time to read it`;n.moment.textContent!==i&&(n.moment.textContent=i),n.theme!==$u()&&Mh(n);for(let r of n.plots){let o=Mp(Zv(n,r),r.spec.lines),a=r.area.clientWidth;a>0&&a!==r.chart.width&&r.chart.setSize({width:a,height:bp}),r.chart.setData(o);let l=CR(n,r,o);r.value.textContent=qn(l(0),r.spec.unit,r.spec.least),[...r.keys.children].forEach((c,u)=>{let f=n.pointed?`${r.spec.names[u]} ${qn(l(u),r.spec.unit,r.spec.least)}`:r.spec.names[u];c.textContent!==f&&(c.textContent=f)})}let s=performance.now();n.rested=s+Math.max(xR,9*(s-t))}function CR(n,{chart:e},t){let i=e.cursor.left>=0?e.cursor.idx:null;if(i==null)for(i=t[0].length-1;i>0&&t[0][i]>n.now;)i-=1;return s=>i>=0?t[1+s][i]??NaN:NaN}function ny(n,e){let t=devicePixelRatio||1,i=n.plots.map(({spec:u,chart:f})=>({spec:u,canvas:f.root.querySelector("canvas")})),s=i[0].canvas.width,r=Math.round(22*t),o=Math.round(34*t),a=document.createElement("canvas");a.width=s,a.height=o+i.reduce((u,{canvas:f})=>u+r+f.height,0)+r;let l=a.getContext("2d");l.fillStyle=Rt("panel"),l.fillRect(0,0,a.width,a.height),l.fillStyle=Rt("ink"),l.font=`600 ${14*t}px system-ui, sans-serif`,l.fillText(e,10*t,22*t);let c=o;l.font=`${12*t}px system-ui, sans-serif`;for(let{spec:u,canvas:f}of i)l.fillText(u.title,10*t,c+15*t),l.drawImage(f,0,c+r),c+=r+f.height;return a}function iy(n){return Xv(n.fast,{force_x:"force x on the hand [N]",force_y:"force y on the hand [N]",force_z:"force z on the hand [N]",torque_x:"torque x on the hand [N m]",torque_y:"torque y on the hand [N m]",torque_z:"torque z on the hand [N m]",penetration:"penetration [m]",stretch:"coupling stretch [m]",energy:"energy put in by the hand [J]",model_age:"age of the contact model [s]"})}var wp=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function sy(n,e){let t=Number.isFinite(n)&&n>0?n:2,[i,s]=wp.find(([r])=>t>=2*r)??wp[wp.length-1];return{scale:i,unit:s+e,decimals:Math.max(1,2-Math.floor(Math.log10(t/i)))}}function ry(n,{scale:e,decimals:t}){if(n==null||!Number.isFinite(n))return"–";let i=n/e;return i.toFixed(Math.abs(i)<999.95?t:0)}function oy(n,e,{workspace:t,tolerance:i}){let s=u=>e.find(f=>f.name===u)?.value,r=n?.force>0?n.force:3.3,o=n?.torque>0?n.torque:.1,a=r/(t?.force_scale>0?t.force_scale:1),l=s("coupling_stiffness"),c=s("contact_stiffness");return{force:r,torque:o,stretch:l>0?a/l:10*i,penetration:c>0?Math.max(a/c,i):i}}var ay=(n,e)=>Number.isFinite(n)&&e>0?Math.min(1,Math.abs(n)/e):0;var cy=[{id:"force",name:"Force",unit:"N",help:"on the hand, as sent to the device; the bar ends at the limit of device and safety"},{id:"torque",name:"Torque",unit:"N m",help:"on the hand, about the handle; the bar ends at the limit of device and safety"},{id:"penetration",name:"Depth",unit:"m",help:"of the deepest contact: how far the surfaces pass into each other, or the gap between them; forces begin before they touch; the bar ends where the contact gives the largest force, or the tolerance"},{id:"stretch",name:"Stretch",unit:"m",help:"from the hand to where it holds the object: the spring that is felt; the bar ends at the limit of the force"}];function uy(n){let e={parent:n,tiles:{},lines:{}},t=le("div","tiles");for(let{id:r,name:o,help:a}of cy){let l=le("div",`tile ${r}`);l.title=a;let c=le("span","number"),u=le("span","unit"),f=le("span","name",o),h=le("i","gauge"),p=le("span","limit");l.append(f,c,u,h,p),t.append(l),e.tiles[r]={tile:l,title:f,number:c,unit:u,gauge:h,limit:p}}let i=le("p","situation"),s=le("ul","lines");for(let r of["limit","rows","level","loop","contact","energy"]){let o=le("li",`line ${r}`),a=le("i","dot"),l=le("span");o.append(a,l),s.append(o),e.lines[r]={line:o,text:l,dot:a}}return n.append(t,i,s),e.said=i,e}var Pl=n=>Math.hypot(...n);function RR(n,e,t){for(let{id:i,unit:s}of cy){let r=n.tiles[i],o=sy(t[i],s),a=ay(e[i],t[i]);bh(r.number,ry(i==="penetration"?Math.abs(e[i]):e[i],o)),bh(r.unit,o.unit),bh(r.limit,`of ${Number((t[i]/o.scale).toPrecision(2))}`),r.gauge.style.setProperty("--share",a.toFixed(3)),r.tile.classList.toggle("full",a>.9)}bh(n.tiles.penetration.title,e.penetration<0?"Gap":"Depth")}function bh(n,e){n.textContent!==e&&(n.textContent=e)}function hy(n,e,t,i,s,r=null){if(!e||!i)return;let o=e.penetration>0;RR(n,r??{force:Pl(e.force),torque:Pl(e.torque),stretch:e.stretch,penetration:e.penetration},oy(t?.limits,s,i)),n.parent.classList.toggle("pointed",!!r);let a=o||Pl(e.contactForce)>0,l={object:i.object.name,statics:i.statics.map(u=>u.name),grasped:(e.bits&1)!==0,armed:(e.bits&6)===2,contacts:e.contactsFound,clusters:e.clusters.length,touching:a},c=(e.bits&Dr.constrained)!==0;n.said.textContent=c?PR(n,l,{snapshot:e,state:t,scene:i,parameters:s}):h0(l);for(let u of["limit","rows"])n.lines[u].line.hidden=!c;LR(n.lines.level,e,i),NR(n.lines.loop,e,t,i),DR(n.lines.contact,e,t),Di(n.lines.energy,"",`The hand has put in ${qn(e.energy,"J",1e-9)}.`)}function PR(n,e,{snapshot:t,state:i,scene:s,parameters:r}){let o=t.rows.filter(({presses:u})=>u).length,a=r.find(({name:u})=>u==="coupling_stiffness")?.value??null,l=i?.constraint??null,c={pressing:o,stiffness:a,stretch:t.stretch,force:Pl(t.force)/s.workspace.force_scale,heldBack:l?.held_back??0,squeezed:l?.squeezed??0,say:qn};return Di(n.lines.limit,c.heldBack>.01||c.squeezed>.1?"warn":"good",d0(c)),Di(n.lines.rows,l?.left_out>0||l?.halvings>0?"warn":"",IR(t,l)),f0({...e,rows:l?.rows??t.rows.length,pressing:o,newtons:qn(Pl(t.force),"N",.001),stiffness:a===null?null:qn(a,"N/m",1)})}function IR({rows:n},e){if(!e)return"Rows: not counted yet.";let t=[`${ii(e.in_model,"row")} in the contact model`];e.halvings>0&&t.push(`more were needed than fit, so its travel was halved ${e.halvings===1?"once":`${e.halvings} times`}`),e.left_out>0&&t.push(`${ii(e.left_out,"contact")} had no room: nothing may move`),Number.isFinite(e.travel)&&e.travel!==null&&t.push(`free for ${qn(e.travel,"m",1e-6)} around`);let i=p0(n);return i>0&&t.push(`${i} at the edge of ${i===1?"its cone":"their cones"}`),`${t.join("; ")}.`}function Di(n,e,t){n.line.dataset.mood=e,n.text.textContent!==t&&(n.text.textContent=t)}function LR(n,e,t){let i=dd(e.contacts),s=t.object.levels>1?` of ${t.object.levels} levels`:"",r="Level of detail: none in use, as nothing is near.",o=i[0]?.[0]===0?", the original surface":"";i.length===1&&(r=`Level of detail at the contacts: ${i[0][0]}${s}${o}.`),i.length>1&&(r=`Levels of detail at the contacts: ${i.map(([l])=>l).join(", ")}${s}; 0 is the finest.`);let a=m0(e.contacts);Di(n,"",a?`${r} Decided ${a}${a.includes("100 %")?"":"; there is nothing finer elsewhere"}.`:r),n.dot.style.background=i.length>0?Br(i[0][0]):""}function NR(n,e,t,i){let s=e.hapticRate,r=i.rate;if(t?.replay)return Di(n,"",`A recording of a loop at ${Math.round(r)} Hz.`);if(!Number.isFinite(s))return Di(n,"","Haptic loop: not measured yet.");if(t?.run!=="running")return Di(n,"",`Haptic loop: ${t?.run??"unknown"}.`);let o=s>=.99*r,a=t?.timing?.missed??null,l=a===null?"":`, ${ii(a,"frame")} missed`;return o?Di(n,"good",`The loop holds ${Math.round(r)} Hz${l}.`):Di(n,"warn",`The loop runs at ${Math.round(s)} of ${Math.round(r)} Hz${l}.`)}function DR(n,e,t){if(t?.replay){let a=Number.isFinite(e.modelAge)?` The model was ${qn(e.modelAge,"s",1e-6)} old.`:"";return Di(n,"",`Contacts are found again where the object was.${a}`)}if(!Number.isFinite(e.contactRate))return Di(n,"","Contacts: not measured yet.");let i=Number.isFinite(e.modelAge)?`; the model is ${qn(e.modelAge,"s",1e-6)} old`:"",r=t?.run==="running"?e.modelWeight>.99?"good":"warn":"",o=e.contactsDropped>0?`; ${e.contactsDropped} did not fit`:"";return Di(n,r,`Contacts found ${Ii(e.contactRate)} times a second, ${qn(e.queryCpu,"s",1e-6)} each${i}${o}.`)}var ly=[["object","the object"],["hand","where the hand holds it"],["coupling","coupling"],["near","rows near"],["press","rows that press"],["cone","friction cone"]];function fy(n,e){let t=!!e&&(e.bits&Dr.constrained)!==0;if(n.hidden=!t,document.body.classList.toggle("constrained",t),!t)return;n.childElementCount===0&&n.replaceChildren(...ly.map(([o,a])=>{let l=le("span",`swatch row-key ${o}`);return l.append(le("i"),le("b","",a),le("em")),l}));let i=e.rows.filter(({presses:o})=>o),s=(e.bits&1)!==0,r={object:null,hand:s?null:0,coupling:s?null:0,near:e.rows.length-i.length,press:i.length,cone:i.filter(({friction:o})=>o>0).length};ly.forEach(([o],a)=>{let l=n.children[a];l.classList.toggle("active",r[o]!==0);let c=r[o]?`×${r[o]}`:"";l.lastChild.textContent!==c&&(l.lastChild.textContent=c)})}function dy(n,e,t,i=""){let s=Math.min(Fs.length,Math.max(t?.object.levels??1,1));if(n.childElementCount!==s+2){let a=Array.from({length:s},(l,c)=>{let u=le("span","swatch",""),f=c===s-1&&t?.object.levels>s?"+":"";return u.append(le("i"),le("b","",`${c}${f}`),le("em")),u.firstChild.style.background=Br(c),u});n.replaceChildren(le("span","legend-title","Level at contacts"),...a,le("span","legend-browsed"))}let r=new Map;for(let[a,l]of dd(e?.contacts??[])){let c=Math.min(a,Fs.length-1);r.set(c,(r.get(c)??0)+l)}let o=i?`Patches of ${i}`:"";n.lastChild.textContent!==o&&(n.lastChild.textContent=o),[...n.children].slice(1,-1).forEach((a,l)=>{let c=r.get(l)??0;a.classList.toggle("active",c>0);let u=c>0?`×${c}`:"";a.lastChild.textContent!==u&&(a.lastChild.textContent=u)})}var UR=100;function py(){return{title:"",objects:[],undone:[],done:[],chosen:0}}function FR(n){let e=(t,i)=>({source:t.source??null,name:t.name,unit:t.unit??1,position:[...i.position],quaternion:[...i.quat_xyzw],friction:t.friction??null,mass:t.mass??null,density:t.density??null,size:2*t.radius});return[e(n.object,n.start),...n.statics.map(t=>e(t,t))]}function my(n,e,t){Object.assign(n,{title:e.title,objects:FR(e)}),n.chosen=Math.min(n.chosen,n.objects.length-1),t||Object.assign(n,{done:[],undone:[]})}function gy(n,e){n.done.push(n.objects),n.done.splice(0,n.done.length-UR),Object.assign(n,{objects:e,undone:[]})}function Il(n){return _y(n,n.done,n.undone)}function wh(n){return _y(n,n.undone,n.done)}function _y(n,e,t){return e.length===0?!1:(t.push(n.objects),n.objects=e.pop(),n.chosen=Math.min(n.chosen,n.objects.length-1),!0)}function xy(n){n.done.length>0&&(n.objects=n.done.pop()),n.chosen=Math.min(n.chosen,n.objects.length-1)}var Ep=(n,e,t)=>n.map((i,s)=>s===e?{...i,...t}:i),Ap=(n,e)=>n.filter((t,i)=>i!==e),vy=(n,e)=>[n[e],...Ap(n,e)];function yy(n,e,t,i){let{min:s,max:r}=e.report.bounds,o=s.map((f,h)=>.5*t*(f+r[h])),a=s.map((f,h)=>t*(r[h]-f)),l=Math.max(...BR(n,i).map(({center:f,radius:h})=>f[0]+h),-1/0),c=.1*Math.max(...a),u=[(Number.isFinite(l)?l+c+.5*a[0]:0)-o[0],-o[1],-o[2]];return[...n,{source:`file:${e.number}`,name:OR(e.name),unit:t,position:u,quaternion:[0,0,0,1],friction:null,mass:null,density:null,size:Math.max(...a)}]}var OR=n=>n.replace(/\.[^.]*$/,"")||n;function BR(n,e){let t=e?[e.object,...e.statics]:[];return n.map((i,s)=>{let r=t[s];return{center:r?cl(i.quaternion,r.center).map((a,l)=>a+i.position[l]):i.position,radius:r?.radius??.5*i.size}})}function Sy({title:n,objects:e}){return{type:"compose",title:n,objects:e.map(({source:t,name:i,unit:s,position:r,quaternion:o,friction:a,mass:l,density:c},u)=>({source:t,name:i,unit:s,position:r,quat_xyzw:o,friction:a,...u===0?{mass:l,density:c}:{}}))}}function My([n,e,t,i]){let s=Math.max(-1,Math.min(1,2*(i*e-t*n))),r=180/Math.PI;return Math.abs(s)>1-1e-9?[0,Math.sign(s)*90,-2*Math.sign(s)*Math.atan2(n,i)*r]:[Math.atan2(2*(i*n+e*t),1-2*(n*n+e*e))*r,Math.asin(s)*r,Math.atan2(2*(i*t+n*e),1-2*(e*e+t*t))*r]}function by(n){let[e,t,i]=n.map((s,r)=>{let o=s*Math.PI/360,a=[0,0,0,Math.cos(o)];return a[r]=Math.sin(o),a});return yi(i,yi(t,e))}var Ll=1e3;function Ey(n,{ask:e,choose:t,handles:i}){let s={parent:n,ask:e,choose:t,handles:i,composition:py(),scene:null,mode:"translate",isOpen:!1,busy:!1,isOwn:!1,saved:"",refused:"",name:""};return addEventListener("keydown",r=>{!s.isOpen||r.target.closest?.("input, select, dialog")||!(r.ctrlKey||r.metaKey)||r.key.toLowerCase()!=="z"||(r.preventDefault(),Tp(s,r.shiftKey?wh:Il))}),s}function Ay(n,e){n.isOpen=e,es(n)}function Ty(n,e){n.scene=e,my(n.composition,e,n.isOwn),es(n)}function Cy(n,e){let{objects:t}=n.composition;for(let{model:i,unit:s}of e)t=yy(t,i,s,n.scene);return n.composition.chosen=t.length-1,Nl(n,t)}function Ry(n,e){return Nl(n,Ep(n.composition.objects,n.composition.chosen,e))}async function Nl(n,e){if(n.busy)return es(n),{ok:!1,reason:"the scene before is still being made"};gy(n.composition,e);let t=await Py(n);return t.ok||xy(n.composition),es(n),t}async function Tp(n,e){if(n.busy||!e(n.composition))return;(await Py(n)).ok||(e===Il?wh:Il)(n.composition),es(n)}async function Py(n){Object.assign(n,{busy:!0,isOwn:!0,saved:"",refused:""}),es(n);let e=await n.ask(Sy(n.composition));return Object.assign(n,{busy:!1,isOwn:!1,refused:e.ok?"":e.reason??"The program refused."}),e}async function wy(n,e){let t=n.name.trim()||n.composition.title.replace(/[^A-Za-z0-9 ._-]/g,"").trim(),i=await n.ask({type:"save",name:t,value:e});i.ok||(n.refused=i.reason??"The program refused."),es(n)}function Iy(n,{file:e}){Object.assign(n,{saved:e,refused:""}),es(n)}function es(n){let{composition:e,isOpen:t,mode:i,busy:s}=n,r=t&&!s&&e.objects.length>0;if(n.handles(r?e.chosen:null,i,t),!t)return;let o=document.activeElement?.dataset?.field,{objects:a,chosen:l}=e,c=le("div","build-list");c.setAttribute("role","listbox"),c.setAttribute("aria-label","Objects of the scene"),c.append(...a.map((f,h)=>{let p=Bn("",()=>{e.chosen=h,es(n)},"open-item");return p.setAttribute("role","option"),p.setAttribute("aria-selected",String(h===l)),p.append(le("b","",f.name),le("span","note",h===0?"in the hand":"stands still")),p}));let u=[kR(n),c];a[l]&&u.push(zR(n,a[l],l)),u.push(GR(n)),n.parent.replaceChildren(...u),n.parent.classList.toggle("busy",s),o&&n.parent.querySelector(`[data-field="${o}"]`)?.focus()}function kR(n){let{composition:e,mode:t,busy:i}=n,s=le("div","build-tools"),r=(l,c)=>{let u=Bn(l,()=>{n.mode=c,es(n)},"chip-button");return u.setAttribute("aria-pressed",String(t===c)),u},o=Bn("Undo",()=>Tp(n,Il)),a=Bn("Redo",()=>Tp(n,wh));return o.disabled=i||e.done.length===0,a.disabled=i||e.undone.length===0,s.append(r("Move","translate"),r("Turn","rotate"),o,a,Bn("Add a mesh",n.choose)),s}function zR(n,e,t){let i=le("div","build-fields"),{objects:s}=n.composition,r=h=>Nl(n,Ep(s,t,h)),o=(h,p,g,y)=>{let d=Object.assign(le("input","value"),{type:"text",value:g,disabled:n.busy});return d.dataset.field=p,d.setAttribute("aria-label",h),d.addEventListener("change",()=>y(d.value,d)),d},a=(h,p,g,y,{open:d=!1}={})=>o(h,p,g===null?"":Ii(g),(m,v)=>{let T=m.trim()===""&&d?null:Number(m.replace(",","."));T!==null&&(m.trim()===""||!Number.isFinite(T))?(n.refused=`"${m}" is not a number.`,es(n)):m!==v.defaultValue&&y(T)}),l=(h,p,...g)=>{let y=le("div","build-row");y.append(le("span","",h),...g,le("span","unit",p)),i.append(y)};l("name","",o("name","name",e.name,h=>r({name:h}))),l("position","mm",...["x","y","z"].map((h,p)=>a(`position ${h}, mm`,`position-${h}`,Ll*e.position[p],g=>r({position:e.position.map((y,d)=>d===p?g/Ll:y)}))));let c=My(e.quaternion);l("turned about","°",...["x","y","z"].map((h,p)=>a(`turned about ${h}, degrees`,`turn-${h}`,c[p],g=>r({quaternion:by(c.map((y,d)=>d===p?g:y))})))),l("friction","",a("friction","friction",e.friction,h=>r({friction:h}),{open:!0})),t===0&&(l("mass","g",a("mass, g","mass",e.mass===null?null:Ll*e.mass,h=>r({mass:h===null?null:h/Ll,density:null}),{open:!0})),l("or density","kg/m³",a("density, kg/m³","density",e.density,h=>r({density:h,mass:null}),{open:!0}))),/^scene:/.test(e.source??"")||l("unit",`m, ${Ii(Ll*e.size)} mm long`,a("metres per unit","unit",e.unit,h=>r({unit:h,size:e.size*h/e.unit}),{}));let u=le("div","build-tools");t>0&&u.append(Bn("Take it in the hand",()=>{n.composition.chosen=0,Nl(n,vy(s,t))}));let f=Bn("Remove",()=>Nl(n,Ap(s,t)));return f.disabled=s.length<2,u.append(f),i.append(u),i}function GR(n){let e=le("div","build-save"),t=Object.assign(le("input","value"),{type:"text",value:n.name,placeholder:n.composition.title});t.dataset.field="save-name",t.setAttribute("aria-label","Name to save it under"),t.addEventListener("change",()=>{n.name=t.value});let i=Bn("Save",()=>wy(n,!1),"primary"),s=Bn("Save as one file",()=>wy(n,!0)),r=le("p",n.refused?"refusal":"note",n.refused||(n.saved?`Saved: ${n.saved}`:""));r.setAttribute("role",n.refused?"alert":"status");let o=le("div","build-tools");return o.append(t,i,s),e.append(o,r),e}var qr=new Er,un=new B,mr=new B,Qt=new At,Ly={X:new B(1,0,0),Y:new B(0,1,0),Z:new B(0,0,1)},Cp={type:"change"},Ny={type:"mouseDown",mode:null},Dy={type:"mouseUp",mode:null},Uy={type:"objectChange"},Rh=class extends Va{constructor(e,t=null){super(void 0,t);let i=new Pp(this);this._root=i;let s=new Ip;this._gizmo=s,i.add(s);let r=new Lp;this._plane=r,i.add(r);let o=this;function a(T,S){let C=S;Object.defineProperty(o,T,{get:function(){return C!==void 0?C:S},set:function(A){C!==A&&(C=A,r[T]=A,s[T]=A,o.dispatchEvent({type:T+"-changed",value:A}),o.dispatchEvent(Cp))}}),o[T]=S,r[T]=S,s[T]=S}a("camera",e),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new B,c=new B,u=new At,f=new At,h=new B,p=new At,g=new B,y=new B,d=new B,m=0,v=new B;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",u),a("worldQuaternionStart",f),a("cameraPosition",h),a("cameraQuaternion",p),a("pointStart",g),a("pointEnd",y),a("rotationAxis",d),a("rotationAngle",m),a("eye",v),this._offset=new B,this._startNorm=new B,this._endNorm=new B,this._cameraScale=new B,this._parentPosition=new B,this._parentQuaternion=new At,this._parentQuaternionInv=new At,this._parentScale=new B,this._worldScaleStart=new B,this._worldQuaternionInv=new At,this._worldScale=new B,this._positionStart=new B,this._quaternionStart=new At,this._scaleStart=new B,this._getPointer=VR.bind(this),this._onPointerDown=WR.bind(this),this._onPointerHover=HR.bind(this),this._onPointerMove=XR.bind(this),this._onPointerUp=qR.bind(this),t!==null&&this.connect(t)}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(e){if(this.object===void 0||this.dragging===!0)return;e!==null&&qr.setFromCamera(e,this.camera);let t=Rp(this._gizmo.picker[this.mode],qr);t?this.axis=t.object.name:this.axis=null}pointerDown(e){if(!(this.object===void 0||this.dragging===!0||e!=null&&e.button!==0)&&this.axis!==null){e!==null&&qr.setFromCamera(e,this.camera);let t=Rp(this._plane,qr,!0);t&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(t.point).sub(this.worldPositionStart)),this.dragging=!0,Ny.mode=this.mode,this.dispatchEvent(Ny)}}pointerMove(e){let t=this.axis,i=this.mode,s=this.object,r=this.space;if(i==="scale"?r="local":(t==="E"||t==="XYZE"||t==="XYZ")&&(r="world"),s===void 0||t===null||this.dragging===!1||e!==null&&e.button!==-1)return;e!==null&&qr.setFromCamera(e,this.camera);let o=Rp(this._plane,qr,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&t!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),t.indexOf("X")===-1&&(this._offset.x=0),t.indexOf("Y")===-1&&(this._offset.y=0),t.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&t!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(Qt.copy(this._quaternionStart).invert()),t.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(un),t.search("X")!==-1&&(un.x=Math.round(un.x/this.translationSnap)*this.translationSnap),t.search("Y")!==-1&&(un.y=Math.round(un.y/this.translationSnap)*this.translationSnap),t.search("Z")!==-1&&(un.z=Math.round(un.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(un)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(t.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),mr.set(a,a,a)}else un.copy(this.pointStart),mr.copy(this.pointEnd),un.applyQuaternion(this._worldQuaternionInv),mr.applyQuaternion(this._worldQuaternionInv),mr.divide(un),t.search("X")===-1&&(mr.x=1),t.search("Y")===-1&&(mr.y=1),t.search("Z")===-1&&(mr.z=1);s.scale.copy(this._scaleStart).multiply(mr),this.scaleSnap&&(t.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),t.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(un.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;t==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(un.copy(this.rotationAxis).cross(this.eye))*a):(t==="X"||t==="Y"||t==="Z")&&(this.rotationAxis.copy(Ly[t]),un.copy(Ly[t]),r==="local"&&un.applyQuaternion(this.worldQuaternion),un.cross(this.eye),un.length()===0?l=!0:this.rotationAngle=this._offset.dot(un.normalize())*a),(t==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&t!=="E"&&t!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(Qt.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(Qt.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Cp),this.dispatchEvent(Uy)}}pointerUp(e){e!==null&&e.button!==0||(this.dragging&&this.axis!==null&&(Dy.mode=this.mode,this.dispatchEvent(Dy)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(e){return this.object=e,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Cp),this.dispatchEvent(Uy),this.pointStart.copy(this.pointEnd))}getRaycaster(){return qr}getMode(){return this.mode}setMode(e){this.mode=e}setTranslationSnap(e){this.translationSnap=e}setRotationSnap(e){this.rotationSnap=e}setScaleSnap(e){this.scaleSnap=e}setSize(e){this.size=e}setSpace(e){this.space=e}setColors(e,t,i,s){let r=this._gizmo.materialLib;r.xAxis.color.set(e),r.yAxis.color.set(t),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(e),r.yAxisTransparent.color.set(t),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(e),r.yAxis._color&&r.yAxis._color.set(t),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(e),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(t),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function VR(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{let e=this.domElement.getBoundingClientRect(),t=this.viewport,i,s,r,o;return t!==null?(i=t.x,s=e.height-t.y-t.w,r=t.z,o=t.w):(i=0,s=0,r=e.width,o=e.height),{x:(n.clientX-e.left-i)/r*2-1,y:-(n.clientY-e.top-s)/o*2+1,button:n.button}}}function HR(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function WR(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function XR(n){this.enabled&&this.pointerMove(this._getPointer(n))}function qR(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function Rp(n,e,t){let i=e.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||t)return i[s];return!1}var Eh=new Ci,zt=new B(0,1,0),Fy=new B(0,0,0),Oy=new vt,Ah=new At,Ch=new At,gs=new B,Ph=new vt,Fl=new B(1,0,0),Yr=new B(0,1,0),Ol=new B(0,0,1),Th=new B,Dl=new B,Ul=new B,Pp=class extends pn{constructor(e){super(),this.isTransformControlsRoot=!0,this.controls=e,this.visible=!1}updateMatrixWorld(e){let t=this.controls;t.object!==void 0&&(t.object.updateMatrixWorld(),t.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):t.object.parent.matrixWorld.decompose(t._parentPosition,t._parentQuaternion,t._parentScale),t.object.matrixWorld.decompose(t.worldPosition,t.worldQuaternion,t._worldScale),t._parentQuaternionInv.copy(t._parentQuaternion).invert(),t._worldQuaternionInv.copy(t.worldQuaternion).invert()),t.camera.updateMatrixWorld(),t.camera.matrixWorld.decompose(t.cameraPosition,t.cameraQuaternion,t._cameraScale),t.camera.isOrthographicCamera?t.camera.getWorldDirection(t.eye).negate():t.eye.copy(t.cameraPosition).sub(t.worldPosition).normalize(),this.parent&&(Ph.copy(this.parent.matrixWorld).invert(),Ph.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(e)}dispose(){this.traverse(function(e){e.geometry&&e.geometry.dispose(),e.material&&e.material.dispose()})}},Ip=class extends pn{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let e=new Xi({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),t=new tr({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=e.clone();i.opacity=.15;let s=t.clone();s.opacity=.5;let r=e.clone();r.color.setHex(16711680);let o=e.clone();o.color.setHex(65280);let a=e.clone();a.color.setHex(255);let l=e.clone();l.color.setHex(16711680),l.opacity=.5;let c=e.clone();c.color.setHex(65280),c.opacity=.5;let u=e.clone();u.color.setHex(255),u.opacity=.5;let f=e.clone();f.opacity=.25;let h=e.clone();h.color.setHex(16776960),h.opacity=.25;let p=e.clone();p.color.setHex(16776960);let g=e.clone();g.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:p,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:u,activeTransparent:h};let y=new Wt(0,.04,.1,12);y.translate(0,.05,0);let d=new cn(.08,.08,.08);d.translate(0,.04,0);let m=new mn;m.setAttribute("position",new Dt([0,0,0,1,0,0],3));let v=new Wt(.0075,.0075,.5,3);v.translate(0,.25,0);function T(V,Y){let G=new qi(V,.0075,3,64,Y*Math.PI*2);return G.rotateY(Math.PI/2),G.rotateX(Math.PI/2),G}function S(){let V=new mn;return V.setAttribute("position",new Dt([0,0,0,1,1,1],3)),V}let C={X:[[new be(y,r),[.5,0,0],[0,0,-Math.PI/2]],[new be(y,r),[-.5,0,0],[0,0,Math.PI/2]],[new be(v,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new be(y,o),[0,.5,0]],[new be(y,o),[0,-.5,0],[Math.PI,0,0]],[new be(v,o)]],Z:[[new be(y,a),[0,0,.5],[Math.PI/2,0,0]],[new be(y,a),[0,0,-.5],[-Math.PI/2,0,0]],[new be(v,a),null,[Math.PI/2,0,0]]],XYZ:[[new be(new nr(.1,0),f),[0,0,0]]],XY:[[new be(new cn(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new be(new cn(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new cn(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},A={X:[[new be(new Wt(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new be(new Wt(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new be(new Wt(.2,0,.6,4),i),[0,.3,0]],[new be(new Wt(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new be(new Wt(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new be(new Wt(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new be(new nr(.2,0),i)]],XY:[[new be(new cn(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new be(new cn(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new cn(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},_={START:[[new be(new nr(.01,2),s),null,null,null,"helper"]],END:[[new be(new nr(.01,2),s),null,null,null,"helper"]],DELTA:[[new xi(S(),s),null,null,null,"helper"]],X:[[new xi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new xi(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new xi(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},w={XYZE:[[new be(T(.5,1),g),null,[0,Math.PI/2,0]]],X:[[new be(T(.5,.5),r)]],Y:[[new be(T(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new be(T(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new be(T(.75,1),h),null,[0,Math.PI/2,0]]]},U={AXIS:[[new xi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},L={XYZE:[[new be(new hs(.25,10,8),i)]],X:[[new be(new qi(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new be(new qi(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new be(new qi(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new be(new qi(.75,.1,2,24),i)]]},I={X:[[new be(d,r),[.5,0,0],[0,0,-Math.PI/2]],[new be(v,r),[0,0,0],[0,0,-Math.PI/2]],[new be(d,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new be(d,o),[0,.5,0]],[new be(v,o)],[new be(d,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new be(d,a),[0,0,.5],[Math.PI/2,0,0]],[new be(v,a),[0,0,0],[Math.PI/2,0,0]],[new be(d,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new be(new cn(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new be(new cn(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new cn(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new be(new cn(.1,.1,.1),f)]]},k={X:[[new be(new Wt(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new be(new Wt(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new be(new Wt(.2,0,.6,4),i),[0,.3,0]],[new be(new Wt(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new be(new Wt(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new be(new Wt(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new be(new cn(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new be(new cn(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new be(new cn(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new be(new cn(.2,.2,.2),i),[0,0,0]]]},W={X:[[new xi(m,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new xi(m,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new xi(m,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function N(V){let Y=new pn;for(let G in V)for(let ae=V[G].length;ae--;){let q=V[G][ae][0].clone(),K=V[G][ae][1],ne=V[G][ae][2],he=V[G][ae][3],fe=V[G][ae][4];q.name=G,q.tag=fe,K&&q.position.set(K[0],K[1],K[2]),ne&&q.rotation.set(ne[0],ne[1],ne[2]),he&&q.scale.set(he[0],he[1],he[2]),q.updateMatrix();let Q=q.geometry.clone();Q.applyMatrix4(q.matrix),q.geometry=Q,q.renderOrder=1/0,q.position.set(0,0,0),q.rotation.set(0,0,0),q.scale.set(1,1,1),Y.add(q)}return Y}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=N(C)),this.add(this.gizmo.rotate=N(w)),this.add(this.gizmo.scale=N(I)),this.add(this.picker.translate=N(A)),this.add(this.picker.rotate=N(L)),this.add(this.picker.scale=N(k)),this.add(this.helper.translate=N(_)),this.add(this.helper.rotate=N(U)),this.add(this.helper.scale=N(W)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(e){let i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:Ch;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(Qt.setFromEuler(Eh.set(0,0,0)),o.quaternion.copy(i).multiply(Qt),Math.abs(zt.copy(Fl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(Qt.setFromEuler(Eh.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(Qt),Math.abs(zt.copy(Yr).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(Qt.setFromEuler(Eh.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(Qt),Math.abs(zt.copy(Ol).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(Qt.setFromEuler(Eh.set(0,Math.PI/2,0)),zt.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(Oy.lookAt(Fy,zt,Yr)),o.quaternion.multiply(Qt),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),un.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),un.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(un),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(zt.copy(Fl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(zt.copy(Yr).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(zt.copy(Ol).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(zt.copy(Ol).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(zt.copy(Fl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(zt.copy(Yr).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(Ah.copy(i),zt.copy(this.eye).applyQuaternion(Qt.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(Oy.lookAt(this.eye,Fy,Yr)),o.name==="X"&&(Qt.setFromAxisAngle(Fl,Math.atan2(-zt.y,zt.z)),Qt.multiplyQuaternions(Ah,Qt),o.quaternion.copy(Qt)),o.name==="Y"&&(Qt.setFromAxisAngle(Yr,Math.atan2(zt.x,zt.z)),Qt.multiplyQuaternions(Ah,Qt),o.quaternion.copy(Qt)),o.name==="Z"&&(Qt.setFromAxisAngle(Ol,Math.atan2(zt.y,zt.x)),Qt.multiplyQuaternions(Ah,Qt),o.quaternion.copy(Qt))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(e)}},Lp=class extends be{constructor(){super(new Ls(1e5,1e5,2,2),new Xi({visible:!1,wireframe:!0,side:Ri,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(e){let t=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(t="local"),Th.copy(Fl).applyQuaternion(t==="local"?this.worldQuaternion:Ch),Dl.copy(Yr).applyQuaternion(t==="local"?this.worldQuaternion:Ch),Ul.copy(Ol).applyQuaternion(t==="local"?this.worldQuaternion:Ch),zt.copy(Dl),this.mode){case"translate":case"scale":switch(this.axis){case"X":zt.copy(this.eye).cross(Th),gs.copy(Th).cross(zt);break;case"Y":zt.copy(this.eye).cross(Dl),gs.copy(Dl).cross(zt);break;case"Z":zt.copy(this.eye).cross(Ul),gs.copy(Ul).cross(zt);break;case"XY":gs.copy(Ul);break;case"YZ":gs.copy(Th);break;case"XZ":zt.copy(Ul),gs.copy(Dl);break;case"XYZ":case"E":gs.set(0,0,0);break}break;default:gs.set(0,0,0)}gs.length()===0?this.quaternion.copy(this.cameraQuaternion):(Ph.lookAt(un.set(0,0,0),gs,zt),this.quaternion.setFromRotationMatrix(Ph)),super.updateMatrixWorld(e)}};function By(n,e){let t=new Rh(n.view.camera,n.canvas),i={stage:n,controls:t,index:null,isDragging:!1};return t.setSize(.9),t.addEventListener("change",()=>{n.dirty=!0}),t.addEventListener("dragging-changed",({value:s})=>{i.isDragging=s;let r=Yn(n)[i.index];!s&&r&&e({position:r.group.position.toArray(),quaternion:r.group.quaternion.toArray()})}),i}function Np(n,e,t){let{stage:i,controls:s}=n,r=e===null?null:Yn(i)[e];n.index=r?e:null;let o=s.getHelper();r?(s.setMode(t),s.attach(r.group),i.scene.add(o)):(s.detach(),i.scene.remove(o)),i.dirty=!0}function ky(n,e){if(n.index===null||e.button!==0)return!1;let t=n.stage.canvas.getBoundingClientRect();return n.controls.pointerHover({x:(e.clientX-t.left)/t.width*2-1,y:1-(e.clientY-t.top)/t.height*2,button:e.button}),n.controls.axis!==null}function Gy(n,e){let t=le("p","note","Choose a level to see its convex patches, each in a colour of its own. What contacts use at this moment stands in the colours of the legend."),i=le("div");return n.append(t,i),{list:i,browse:e,rows:[],scene:null}}function Vy(n,e){n.scene=e;let t=[e.object,...e.statics];n.rows=t.map((i,s)=>YR(n,i,s)),n.list.replaceChildren(...n.rows.map(i=>i.box))}function YR(n,e,t){let i=le("section","level-row"),s=le("div","level-head"),r=le("i",t===0?"held":"fixed");s.append(r,le("h2","",e.name),le("span","note",ii(e.levels,"level")));let o=le("div","chips");o.setAttribute("role","radiogroup"),o.setAttribute("aria-label",`Level of the ${e.name}`);let a=le("p","note"),l={box:i,about:e,body:t,caption:a,chips:[],level:null},c=[null,...(e.level_list??[]).keys()];for(let u of c){let f=Object.assign(le("button","chip-button",u===null?"as it is":String(u)),{type:"button"});f.setAttribute("role","radio"),f.setAttribute("aria-label",u===null?`${e.name} as it is`:`${e.name}, level ${u}`),u!==null&&u>0&&e.level_list[u].free&&f.classList.add("free"),f.addEventListener("click",()=>zy(n,l,u)),l.chips.push({chip:f,level:u}),o.append(f)}return i.append(s,o,a),zy(n,l,null),l}function zy(n,e,t){let i=e.level!==t;e.level=t;for(let{chip:s,level:r}of e.chips)s.setAttribute("aria-checked",String(r===t));e.caption.textContent=$R(e.about,t),i&&n.browse(e.body,t)}function $R(n,e){if(e===null)return"";let t=n.level_list[e];return e===0?`The original surface: ${ii(t.triangles,"triangle")} in ${ii(t.patches,"convex patch","convex patches")}.`:eh({about:n},e)?`${ii(t.triangles,"triangle")} in ${ii(t.patches,"convex patch","convex patches")}; nowhere more than ${qn(t.deviation,"m",1e-9)} off the original.`:`${ii(t.patches,"group")} of patches below, merged pairwise. No surface of its own: contacts here are with convex hulls.`}function Hy(n){return n.rows.filter(e=>e.level!==null).map(e=>`${e.about.name} ${e.level}`).join(", ")}var Dp={ball_joint:{size:.076,triangles:274120},block_on_gear:{size:.1,triangles:1616},blocks:{size:.1,triangles:32},conforming:{size:.2,triangles:2e5},cup_spoon:{size:.2,triangles:149988},ellipsoid:{size:.02,triangles:22002},file_on_cad:{size:.2,triangles:1344},golf:{size:.12,triangles:282764},hammer_on_torus:{size:.24,triangles:1036},jaws:{size:.074,triangles:87514},plate:{size:.1,triangles:2016},simple_cup_spoon:{size:.2,triangles:5340},spoon_in_cup:{size:.2,triangles:149988}};var Wy={ball_joint:"Turn the ball in its socket: it has half a millimetre of play.",block_on_gear:"Drag the block over the gear: ridges catch ridges.",blocks:"Turn the upper block about the vertical: its stripes climb out of the others.",conforming:"Press the waves together and turn: everything touches at once.",cup_spoon:"Lead the spoon through the handle of the cup.",ellipsoid:"Roll the ellipsoid over the ball; its tip and its flank feel different.",file_on_cad:"Scrape the file over the flange: rough on rough.",golf:"Tap the ball, then slide the club over its dimples.",hammer_on_torus:"Stroke the ring with the hammer, along and across its ridges.",jaws:"Close the bite, then slide the cusps over each other.",plate:"Draw the probe across the ridges, slowly and fast.",simple_cup_spoon:"Lead the spoon through the handle: few triangles, the same way.",spoon_in_cup:"Nobody holds it: watch the spoon fall into the cup."},Xy=n=>Wy[n]??"",JN=Object.keys(Wy);var ZR=96,JR=[["millimetres",.001],["centimetres",.01],["inches",.0254],["metres",1]];function $y(n,{ask:e,send:t,room:i,limit:s,add:r}){let o={dialog:n,ask:e,send:t,room:i,limit:s,add:r,menu:{scenes:[],recordings:[],meshes:[]},name:"",model:null,busy:null};n.addEventListener("click",a=>{a.target===n&&n.close()});for(let a of["dragenter","dragover"])addEventListener(a,l=>{[...l.dataTransfer?.types??[]].includes("Files")&&(l.preventDefault(),document.body.classList.add("dropping"))});return addEventListener("dragleave",a=>{a.relatedTarget||document.body.classList.remove("dropping")}),addEventListener("drop",a=>{a.preventDefault(),document.body.classList.remove("dropping"),Ky(o,[...a.dataTransfer?.files??[]])}),o}function Zy(n,e){n.menu=e,n.dialog.open&&!n.model&&jy(n)}function Jy(n,e){n.name=e,n.model=null,jy(n),n.dialog.open||n.dialog.showModal()}function jy(n){let{scenes:e,recordings:t,meshes:i=[]}=n.menu,s=l=>{let c=le("div","open-list");return c.append(...l.map(({name:u,title:f})=>{let h=Bn("",()=>KR(n,u),"open-item");h.append(le("b","",f||u));let p=Xy(u)||(f&&f!==u?u:"");return p&&h.append(le("span","note",p)),jR(h,u),h.setAttribute("aria-current",String(u===n.name)),h})),c},r=Object.assign(le("input"),{type:"file",accept:g0(i),id:"mesh-file",multiple:!0});r.addEventListener("change",()=>Ky(n,[...r.files]));let o=le("label","drop-zone");o.htmlFor=r.id,o.append(le("b","","Files of your own"),le("span","note",_0(i)),r);let a=[le("h2","","Open"),o,le("h3","","Scenes"),s(e)];t.length>0&&a.push(le("h3","","Recordings"),s(t)),n.dialog.replaceChildren(...a,Up(n,[Bn("Cancel",()=>n.dialog.close())]))}function jR(n,e){let t=Dp[e];if(!t)return;let i=le("i","open-picture");i.style.backgroundPositionY=`${(-ZR*Object.keys(Dp).indexOf(e)).toFixed(0)}px`,i.setAttribute("aria-hidden","true"),n.classList.add("pictured"),n.append(le("span","note",`${Ii(1e3*t.size)} mm, ${ii(t.triangles,"triangle")}`),i)}function Up(n,e,t=""){let i=le("div","dialog-foot"),s=le("p","refusal",t);return s.setAttribute("role","alert"),i.append(s,...e),n.said=s,i}async function KR(n,e){(await Fp(n,{type:"open",value:e})).ok&&n.dialog.close()}async function Fp(n,e){if(n.busy)return{ok:!1};n.dialog.classList.add("busy"),n.busy=n.ask(e);let t=await n.busy;return n.busy=null,n.dialog.classList.remove("busy"),!t.ok&&n.said&&(n.said.textContent=t.reason??"The program refused."),t}async function Ky(n,e){if(e.length<=1){e[0]&&await qy(n,e[0]);return}let t=[];for(let i of e){if(!(await qy(n,i)).ok||n.model?.report===void 0||n.model.report.verdict==="rejected")return;t.push({model:n.model,unit:n.model.unit})}n.dialog.close(),n.add(t)}async function qy(n,e){for(;n.busy;)await n.busy;n.model={name:e.name};let t=Object.assign(le("progress"),{max:1,value:0});n.dialog.replaceChildren(le("h2","",e.name),le("p","note","Sending and looking at it …"),t,Up(n,[Bn("Cancel",()=>n.dialog.close())])),n.dialog.open||n.dialog.showModal();let i=new Uint8Array(await e.arrayBuffer()),s=Fp(n,{type:"upload",name:e.name.slice(-120),value:i.length});await QR(n,i,t);let r=await s;return r.ok&&e.name.endsWith(".mcap")&&n.dialog.close(),r}async function QR(n,e,t){let i=Math.max(1024,Math.min(n.limit(),65536)-64);for(let s=0;s<e.length&&n.busy;){for(let r=0;r<8&&s<e.length&&n.room()<4*i;r++){if(!n.send(A0(e.subarray(s,s+i))))return;s+=i}t.value=Math.min(1,s/e.length),await new Promise(r=>setTimeout(r,10))}}function Qy(n,e){n.model=e;let{report:t}=e,i=t.verdict==="usable",s=t.verdict==="repairable",r=le("p",`verdict ${t.verdict}`,{usable:"Ready to use",repairable:"Needs repair first",rejected:"Cannot be used"}[t.verdict]??t.verdict),o=le("p","",`${ii(t.triangles,"triangle")}, ${t.closed?"closed":"open"}, ${ii(t.components,"part")}.`),a=le("ul","reasons");for(let y of[...t.reasons,...t.warnings])a.append(le("li","",y));let l=Object.assign(le("select"),{id:"mesh-unit"}),c=[...JR.map(([y,d])=>[`${y} (${Yy(t,d)})`,d]),[`whatever makes it as large as the object (${Yy(t,e.object_radius/t.radius)})`,e.object_radius/t.radius]];l.append(...c.map(([y,d])=>new Option(y,String(d)))),l.value=String(e.unit);let u=Object.assign(le("label","","Its unit is "),{htmlFor:l.id}),f=le("p","unit-choice");f.append(u,l);let h=y=>async()=>{(await Fp(n,{type:"place",name:y,value:Number(l.value),repair:s})).ok&&n.dialog.close()},p=s?"Repair and ":"",g=[Bn("Cancel",()=>n.dialog.close())];(i||s)&&(g.push(Bn("Add it to the scene",async()=>{n.dialog.close(),n.add([{model:e,unit:Number(l.value)}])})),g.push(Bn(p?"Repair and touch it":"Touch it",h("touch")),Bn(p?"Repair and hold it":"Hold it",h("hold"),"primary"))),n.dialog.replaceChildren(le("h2","",e.name),r,o,a,...i||s?[f]:[],Up(n,g)),n.dialog.open||n.dialog.showModal()}function Yy(n,e){let t=e*Math.max(...n.bounds.max.map((i,s)=>i-n.bounds.min[s]));return Number.isFinite(t)?t<.9995?`${Ii(1e3*t)} mm`:`${Ii(t)} m`:"–"}var eP=[.05,.1,.25,.5,1,2,4];function eS(n,e){let t={parent:n,act:e,held:!1,waiting:!1,next:null};t.play=ci("pause","Pause","P",e.pause),t.slider=Object.assign(document.createElement("input"),{type:"range",min:0,max:1,step:"any"}),t.slider.setAttribute("aria-label","Time in the recording"),t.text=document.createElement("output"),t.slider.addEventListener("input",()=>{t.held=!0,tS(t,Number(t.slider.value))});for(let s of["change","blur"])t.slider.addEventListener(s,()=>{t.held=!1});t.speed=Object.assign(document.createElement("select"),{title:"How fast it is shown"}),t.speed.setAttribute("aria-label",t.speed.title),t.speed.append(...eP.map(s=>new Option(`${s} ×`,String(s)))),t.speed.value="1",t.speed.addEventListener("change",()=>e.speed(Number(t.speed.value))),t.strip=document.createElement("canvas"),t.strip.setAttribute("aria-hidden","true"),t.force=[];let i=Object.assign(document.createElement("div"),{className:"track"});return i.append(t.strip,t.slider),n.append(t.play,i,t.speed,t.text),t}async function tS(n,e){if(n.waiting){n.next=e;return}n.waiting=!0,await n.act.seek(e),n.waiting=!1;let t=n.next;n.next=null,t!==null&&tS(n,t)}function nS(n,{force:e}){n.force=e,n.drawnAt=null}function tP(n){let{clientWidth:e,clientHeight:t}=n.strip,i=Rt("force"),s=`${e} ${t} ${i}`;if(n.drawnAt===s||e===0)return;n.drawnAt=s,Object.assign(n.strip,{width:e,height:t});let r=n.strip.getContext("2d"),o=n.force.reduce((a,l)=>Math.max(a,l??0),0);r.clearRect(0,0,e,t),r.fillStyle=i,n.force.forEach((a,l)=>{let c=o>0?t*(a??0)/o:0;r.fillRect(l*e/n.force.length,t-c,e/n.force.length+.5,c)})}function iS(n,e,t){let i=e?.replay??null;if(n.parent.hidden=!i,!i)return;let s=n.held||n.waiting?Number(n.slider.value):t?.time??0;n.slider.max=i.seconds,!n.held&&!n.waiting&&(n.slider.value=s),n.slider.setAttribute("aria-valuetext",`${Lr(s)} of ${Lr(i.seconds)}`),n.text.textContent=`${Lr(s)} / ${Lr(i.seconds)}`,document.activeElement!==n.speed&&(n.speed.value=String(i.speed??1)),tP(n);let r=e.run==="paused";rl(n.play,r?"play":"pause"),zo(n.play,r?"Play":"Hold","P")}var sS=26,nP=110,Op=[["1","+x",[1,0,0]],["2","-x",[-1,0,0]],["3","+y",[0,1,0]],["4","-y",[0,-1,0]],["5","+z",[0,0,1]],["6","-z",[0,0,-1]]];function oS(n,e,t){let i=le("div","compass"),s=document.createElementNS("http://www.w3.org/2000/svg","svg");i.setAttribute("role","group"),i.setAttribute("aria-label","Views along the axes"),s.setAttribute("viewBox","-36 -36 72 72"),s.setAttribute("aria-hidden","true"),i.append(s);let r=Op.map(([l,c,u])=>{let f=document.createElementNS("http://www.w3.org/2000/svg","line"),h=Object.assign(le("button",`axis axis-${c[1]} ${c[0]==="+"?"plus":"minus"}`,c[0]==="+"?c[1]:""),{type:"button",title:`View from ${c} (${l})`});return h.setAttribute("aria-label",`View from ${c}`),h.addEventListener("click",()=>t(u)),f.classList.add(`axis-${c[1]}`),c[0]==="+"&&s.append(f),i.append(h),{way:new B(...u),line:f,button:h}}),o=l=>{let c=le("div",`ruler ${l}`),u=le("span"),f=le("i");return c.append(u,f),{box:c,text:u,length:f}},a={parent:n,names:e,ends:r,scale:o("ruler-scale"),force:o("ruler-force"),tags:[]};return n.replaceChildren(a.force.box,a.scale.box,i),a}function aS(n,e,t){let{view:i,options:s,canvas:r}=e;if(!e.object||r.clientHeight===0)return;let{right:o,up:a,forward:l}=ar(i);for(let{way:h,line:p,button:g}of n.ends){let y=sS*h.dot(o),d=-sS*h.dot(a);p.setAttribute("x2",y.toFixed(1)),p.setAttribute("y2",d.toFixed(1)),g.style.transform=`translate(${y.toFixed(1)}px, ${d.toFixed(1)}px)`,g.style.zIndex=h.dot(l)<0?2:1}let c=e.root.localToWorld(e.object.group.position.clone()),u=il(i,sl(i,c),r.clientHeight)*e.radius;rS(n.scale,u,"m",1e-9);let f=t?.metresPerNewton;n.force.box.hidden=!(f>0)||!s.forces,f>0&&rS(n.force,u/(Gd*f),"N",1e-6),iP(n,e,a)}function rS({text:n,length:e},t,i,s){let r=I0(nP*t),o=qn(r,i,s).replace(/\.0+(?= )/,"");n.textContent!==o&&(n.textContent=o),e.style.width=`${(r/t).toFixed(1)}px`}function iP(n,e,t){let{options:i,view:s,canvas:r}=e,o=Yn(e);if(n.names.hidden=!i.names,!i.names)return;(n.tags.length!==o.length||n.tags.some(({textContent:l},c)=>l!==o[c].about.name))&&(n.tags=o.map(({about:l},c)=>le("span",`name-tag ${c===0?"held":"fixed"}`,l.name)),n.names.replaceChildren(...n.tags));let a=new B;o.forEach(({about:l,group:c},u)=>{e.root.localToWorld(a.set(...l.center).applyQuaternion(c.quaternion).add(c.position)),a.addScaledVector(t,(u===0?.8:-.8)*l.radius/e.radius).project(s.camera);let f=(a.x+1)/2*r.clientWidth,h=(1-a.y)/2*r.clientHeight,p=a.z<1&&f>0&&f<r.clientWidth&&h>0&&h<r.clientHeight;n.tags[u].style.visibility=p?"":"hidden",n.tags[u].style.transform=`translate(${f.toFixed(0)}px, ${h.toFixed(0)}px) translate(-50%, -50%)`})}function sP(n,e,t){let i=e?[e,...n]:n,s=i[0]?.time??0,r=(i.at(-1)?.time??0)-s;if(!(r>0)||r>1||!(t>0))return{samples:new Float32Array(0),last:i.at(-1)??null};let o=new Float32Array(Math.floor(r*8e3)),a=1;for(let l=0;l<o.length;l++){let c=s+l/8e3;for(;a<i.length-1&&i[a].time<c;)a+=1;let u=(i[a].force-i[a-1].force)/t;o[l]=Number.isFinite(u)?Math.tanh(12*u):0}return{samples:o,last:i.at(-1)}}var lS=()=>({context:null,on:!1,last:null,until:0,played:0});function cS(n){return n.on=!n.on,n.last=null,n.on?(n.context??=new AudioContext,n.context.resume()):n.context?.suspend(),n.on}function uS(n,e,t,i){if(!n.on||!n.context)return;let s=Array.from({length:e.rows},(f,h)=>{let p=g=>e.values[h*e.columns+t[g]];return{time:e.time+p("t"),force:Math.hypot(p("force_x"),p("force_y"),p("force_z"))}}),{samples:r,last:o}=sP(s,n.last,i);if(n.last=o,r.length===0)return;let{context:a}=n,l=a.createBuffer(1,r.length,8e3);l.copyToChannel(r,0);let c=new AudioBufferSourceNode(a,{buffer:l});c.connect(a.destination);let u=a.currentTime;(n.until<u||n.until>u+3*.08)&&(n.until=u+.08),c.start(n.until),n.until+=r.length/8e3,n.played+=1}function hS(n,e,t=()=>{}){let i=e.map(([r,o])=>{let a=Object.assign(document.createElement("button"),{type:"button",textContent:o});return a.setAttribute("role","tab"),a.setAttribute("aria-controls",r),a.addEventListener("click",()=>s(r)),{id:r,tab:a}});function s(r){for(let{id:o,tab:a}of i)a.setAttribute("aria-selected",String(o===r)),a.tabIndex=o===r?0:-1,document.getElementById(o).hidden=o!==r;t(r)}return n.addEventListener("keydown",({key:r})=>{let o={ArrowRight:1,ArrowLeft:-1}[r],a=i.findIndex(({tab:c})=>c===document.activeElement);if(!o||a<0)return;let l=i[(a+o+i.length)%i.length];s(l.id),l.tab.focus()}),n.append(...i.map(({tab:r})=>r)),s(e[0][0]),s}var rP=.06,oP=1.5;function Ih(n,e,t){let i=Math.max(rP,Math.min(oP,e)),s=yi(Xu([0,0,1],n+Math.PI/2),Xu([1,0,0],Math.PI/2));return{azimuth:n,radius:t,shown:i,turn:s,metres:t/i}}function fS(){return{source:null,last:null,isHeld:!1,down:new Set}}function dS(n,e,t,i,s){let r=new Set(n.down);for(let{source:a,grabs:l}of e)l?n.down.add(a):n.down.delete(a);if(n.source===null){let a=e.find(({source:l,grabs:c,pose:u})=>c&&u&&!r.has(l));return a?(Object.assign(n,{source:a.source,last:a.pose,isHeld:!1}),"press"):null}let o=e.find(({source:a})=>a===n.source);return!o?.grabs||!o.pose||n.isHeld&&!i.clutch?(Lh(n),"letGo"):(n.isHeld||=i.clutch,o.free||aP(n.last,o.pose,t,i,s),n.last=o.pose,null)}function Lh(n){Object.assign(n,{source:null,last:null,isHeld:!1})}function aP(n,e,t,i,s){let r=cl(t.turn,e.position.map((a,l)=>a-n.position[l]));qu(i,r.map(a=>a*t.metres),s);let o=yi(e.quaternion,Ur(n.quaternion));yd(i,yi(yi(t.turn,o),Ur(t.turn)),s)}var pS=[["immersive-vr","Enter VR"],["immersive-ar","Enter AR"]],lP=[0,-.3,-.55],cP=.22,uP=.2,Bp=60;async function gS(n=navigator.xr){if(!n)return[];let e=await Promise.all(pS.map(([t])=>n.isSessionSupported(t).catch(()=>!1)));return pS.filter((t,i)=>e[i])}function _S(n){return{world:n,session:null,mode:null,busy:!1,rig:new ln,room:null,hand:fS(),grabbing:new Set,freeing:new Set,last:0,pulsed:0,frames:0}}var xS=n=>!!n?.session&&n.hand.source!==null;async function vS(n,e){if(!n.busy){if(n.session){await n.session.end();return}n.busy=!0;try{await hP(n,e)}finally{n.busy=!1}n.world.changed()}}async function hP(n,e){let{stage:t}=n.world,{renderer:i}=t,s=await navigator.xr.requestSession(e,{optionalFeatures:["hand-tracking"]});s.addEventListener("visibilitychange",()=>{s.visibilityState!=="visible"&&yS(n)});for(let[o,a]of[["select",n.grabbing],["squeeze",n.freeing]])s.addEventListener(`${o}start`,({inputSource:l})=>a.add(l)),s.addEventListener(`${o}end`,({inputSource:l})=>a.delete(l));Object.assign(n,{session:s,mode:e,last:0,frames:0}),kp(n,Ih(t.view.azimuth,cP,t.radius)),t.scene.add(n.rig),n.rig.add(t.view.camera),i.xr.enabled=!0,i.xr.setReferenceSpaceType("local"),e==="immersive-vr"&&i.setClearColor(Rt("stage"),1);let r=i.xr.setSession(s);s.addEventListener("end",()=>mS(n,s));try{await r}catch(o){throw await s.end().catch(()=>{}),mS(n,s),o}n.session===s&&i.xr.setAnimationLoop((o,a)=>dP(n,o,a))}function kp(n,e){let{rig:t,world:{stage:i}}=n;n.room=e,t.quaternion.fromArray(e.turn),t.scale.setScalar(1/e.shown),t.position.fromArray(lP).applyQuaternion(t.quaternion).multiplyScalar(-1/e.shown).add(i.view.target),t.updateMatrixWorld()}function mS(n,e){if(n.session!==e)return;let{stage:t,leave:i,changed:s}=n.world,{renderer:r}=t;n.session=n.mode=null,yS(n),i();for(let o of[n.grabbing,n.freeing,n.hand.down])o.clear();r.xr.setAnimationLoop(null),r.setAnimationLoop(null),r.xr.enabled=!1,r.setClearColor(0,0),n.rig.remove(t.view.camera),t.scene.remove(n.rig),t.view.camera.scale.setScalar(1),yl(t),Ji(t.view),s()}function yS(n){n.hand.source!==null&&(Lh(n.hand),n.world.player.letGo())}function fP(n,e,t){let i=n.getPose(e.gripSpace,t);if(!i||i.emulatedPosition)return null;let{position:s,orientation:r}=i.transform;return{position:[s.x,s.y,s.z],quaternion:[r.x,r.y,r.z,r.w]}}function dP(n,e,t){let{world:i,session:s}=n;if(!s)return;n.room.radius!==i.stage.radius&&kp(n,Ih(n.room.azimuth,n.room.shown,i.stage.radius));let r=Math.min(.1,(e-n.last)/1e3);n.last=e,n.frames+=1;let o=i.stage.renderer.xr.getReferenceSpace(),a=[...s.inputSources].filter(({gripSpace:c})=>c).map(c=>({source:c,grabs:n.grabbing.has(c),free:n.freeing.has(c),pose:fP(t,c,o)}));if(pP(n,a),n.hand.source===null)for(let{source:c}of a)mP(n,c,r);else gP(n,e);i.moment();let{stage:l}=i;l.renderer.shadowMap.needsUpdate=l.moved,l.moved=l.dirty=!1,l.renderer.render(l.scene,l.view.camera)}function pP(n,e){let{player:t,take:i}=n.world,s=dS(n.hand,e,n.room,t.hand,t.workspace());s==="letGo"?t.letGo():s==="press"&&!t.mayMove()?(Lh(n.hand),i()):s==="press"&&t.press(),n.hand.source!==null&&(cr(t.hand,performance.now()/1e3),t.moved(!0),t.give())}function mP(n,{gamepad:e},t){let[,,i=0,s=0]=e?.axes??[];if(Math.hypot(i,s)<uP)return;let{azimuth:r,shown:o}=n.room;kp(n,Ih(r+1.5*t*i,o*Math.exp(-1.2*t*s),n.world.stage.radius))}function gP(n,e){let{gamepad:t}=n.hand.source,i=n.world.strength();if(!t||i<.02||e-n.pulsed<Bp)return;n.pulsed=e;let[s]=t.hapticActuators??[];s?.pulse?s.pulse(i,Bp+20)?.catch?.(()=>{}):t.vibrationActuator?.playEffect?.("dual-rumble",{duration:Bp+20,strongMagnitude:i,weakMagnitude:.5*i}).catch(()=>{})}var Gt=n=>document.getElementById(n),_P=50,de={connected:!1,hello:null,scene:null,meshes:new Map,state:null,parameters:[],snapshot:null,shown:null,refusal:null,counts:{snapshot:0,channels:0,mesh:0,event:0},holding:!1,turned:!1,trouble:null,progress:null,fresh:!1,asking:!1,sent:0,faultName:()=>de.hello?.faults?.[de.snapshot?.fault??0]??"fault"},ri=C0(),xP=M0(),it=null,ui=null,ta=null,Gs=null,Ui=$v(Gt("plots"),[["PNG","Save the plots as a picture",()=>ny(Ui,PP()).toBlob(n=>SS(MS("png"),n))],["CSV","Save the plots as a table",()=>SS(MS("csv"),new Blob([iy(Ui)],{type:"text/csv"}))]],n=>de.state?.replay&&en.seek(n)),vP=uy(Gt("readouts")),Vp=lS(),AS=Gy(Gt("levels"),(n,e)=>it&&Yn(it)[n]&&J_(it,Yn(it)[n],e)),Gp=$y(Gt("opener"),{ask:n=>fr(ui,n),send:n=>cx(ui,n),room:()=>ux(ui),limit:()=>de.hello?.max_message??4096,add:n=>{IP("build"),Cy(na,n)}}),na=Ey(Gt("build"),{ask:n=>fr(ui,n),choose:()=>{en.open(),Gt("mesh-file").click()},handles:(n,e,t)=>{it&&(Y_(it,t),t&&!Gs&&(Gs=By(it,i=>Ry(na,i))),Gs&&Np(Gs,n,e))}}),yP=px(Gt("parameters"),(n,e)=>fr(ui,{type:"set",name:n,value:e}));async function zs(n){let e=await fr(ui,n);return e.ok||(de.refusal={text:e.reason??"The program refused.",until:performance.now()/1e3+6}),e}var en={open:()=>Gt("opener").open?Gt("opener").close():Jy(Gp,de.scene?.name??""),seek:n=>zs({type:"seek",value:n}),pause:()=>zs({type:"pause",value:de.state?.run!=="paused"}),step:()=>zs({type:"step",value:1}),reset:()=>zs({type:"reset"}),record:()=>zs({type:"record",value:!de.state?.recording}),device:n=>zs({type:"use_device",value:n}).then(e=>kl(e.ok&&n.startsWith("web:"))),help:()=>Gt("help").open?Gt("help").close():SP(),theme:()=>bP(),view:n=>{it&&(j_(it,{[n]:!it.options[n]}),gd(ia,it.options))},fit:()=>it&&zu(it.view),speed:n=>zs({type:"speed",value:n}),sound:()=>md(ia,cS(Vp)),look:n=>it&&l0(it.view,n),zoom:n=>it&&ko(it.view,n)};function SP(){Gt("help").showModal(),Gt("help").scrollTop=0}var ia=x0(en),MP=oS(Gt("rulers"),Gt("names"),en.look),TS=eS(Gt("replay"),en),bP=k0(()=>{it&&sh(it),Mh(Ui)}),wP={hello:n=>{de.hello=n},scene:n=>{let e=n.refined&&de.snapshot!==null;de.scene=n,de.meshes.clear(),Vy(AS,n),!e&&(de.scene.refined=!1,de.snapshot=de.shown=null,de.fresh=!1,gr("Loading the objects …"))},mesh:n=>{if(de.counts.mesh+=1,de.meshes.set(n.number,n),![de.scene.object,...de.scene.statics].map(i=>i.mesh).every(i=>de.meshes.has(i)))return;let t=de.scene.refined;Gs&&!t&&Np(Gs,null),it&&X_(it,de.scene,de.meshes,t),Ty(na,de.scene),t||gr(de.trouble)},level:n=>{it&&$_(it,n)},relief:n=>{it&&Z_(it,n)},strip:n=>nS(TS,n),menu:n=>Zy(Gp,n),model:n=>Qy(Gp,n),saved:n=>Iy(na,n),progress:({what:n,share:e})=>{de.progress=n,n?(Gt("opener").close(),gr(`${n[0].toUpperCase()}${n.slice(1)} …`,e,()=>zs({type:"cancel"}))):gr(de.trouble)},parameters:n=>{de.parameters=n.list,mx(yP,n.list)},state:n=>{de.state&&de.state.session!==n.session&&EP(),de.state=n,kl(n.holder==="you")},event:n=>{de.counts.event+=1,_x(Gt("events"),n),Jv(Ui,n.time,n.kind),["recording_ended","held_back","squeezed"].includes(n.kind)&&(de.refusal={text:`${Hu(n)}.`,until:performance.now()/1e3+10})},camera:n=>{it&&cd(it.view,n)},channels:n=>{de.counts.channels+=1;let e=["t",...de.hello.channels.map(t=>t.name).filter(t=>t!=="t")];Kv(Ui,n,e),uS(Vp,n,Object.fromEntries(e.map((t,i)=>[t,i])),de.state?.limits?.force??Wp())},snapshot:n=>{de.counts.snapshot+=1;let e=n.bits&~(de.snapshot?.bits??0);de.snapshot=n,e&Dr.fault&&(ri.clutch=!1),de.fresh=!0,n.metresPerNewton>0&&jv(Ui,de.scene.object.radius,de.scene.tolerance,n.metresPerNewton),Qv(Ui,n.time,n.hapticRate,n.contactRate)}};function EP(){ri.clutch=!1,it&&cd(it.view,null),ey(Ui),Gt("events").replaceChildren()}function gr(n,e=null,t=null){let i=Gt("veil");if(i.hidden=!n,i.classList.toggle("working",e!==null),!n){i.replaceChildren();return}if(e!==null&&i.querySelector("progress")){i.querySelector("p").textContent=n,i.querySelector("progress").value=e;return}let s=Object.assign(document.createElement("p"),{textContent:n}),r=Object.assign(document.createElement("progress"),{max:1,value:e??0});r.setAttribute("aria-label","How far it is");let o=Object.assign(document.createElement("button"),{type:"button",className:"primary",textContent:"Cancel"});o.addEventListener("click",t??(()=>{})),i.replaceChildren(s,...e===null?[]:[r],...t?[o]:[])}function AP(n){de.connected=!1,kl(!1),ri.clutch=!1,Md(ri),document.body.classList.add("lost"),de.progress=null,gr(`${n} Nothing is felt or shown any more. ${ui?.stopped?"":"Trying again …"}`)}function TP(){de.connected=!0,document.body.classList.remove("lost"),gr(null)}var $r={get stage(){return it},hand:ri,workspace:()=>de.scene.workspace,grasp:()=>de.snapshot?.grasp??[0,0,0],claims:n=>Gs!==null&&ky(Gs,n),mayMove:()=>de.connected&&!it?.editing&&de.hello?.may_control!==!1&&!!de.state?.device.startsWith("web:")&&de.state.holder!=="other"&&de.state.run!=="ended"&&!de.state.replay&&!!de.snapshot,async press(){if(ri.clutch&&de.holding||de.asking)return;de.asking=!0;let n=Sd(ri);de.holding||kl((await zs({type:"hold",value:!0})).ok),de.asking=!1,de.holding&&(cr(ri,performance.now()/1e3,n),ri.clutch=!0,Nh())},moved:n=>{de.turned||=n},give:CS,letGo:()=>{ri.clutch=!1,Nh()}};function kl(n){de.holding&&!n&&lx(ui),de.holding=n}function CS(){if(!de.holding||!de.connected)return;let n=Md(ri);ax(ui,n),de.sent+=n.length}function Nh(){!de.holding||xS(ta)||(cr(ri,performance.now()/1e3),CS())}function Hp(){de.holding&&($r.letGo(),kl(!1),fr(ui,{type:"hold",value:!1}))}document.addEventListener("visibilitychange",()=>{document.hidden&&Hp()});addEventListener("pagehide",Hp);addEventListener("keydown",n=>{if(n.target.closest?.("input, select, textarea")||n.ctrlKey||n.metaKey||n.altKey)return;let i={" ":()=>ri.clutch?$r.letGo():$r.mayMove()&&$r.press(),p:en.pause,".":en.step,r:en.reset,f:en.fit,o:en.open,"?":en.help,h:en.help,l:()=>en.view("wireframe"),g:()=>en.view("ghost"),c:()=>en.view("contacts"),a:()=>en.view("forces"),n:()=>en.view("names"),s:en.sound,"+":()=>en.zoom(.87),"-":()=>en.zoom(1.15),...Object.fromEntries(Op.map(([s,,r])=>[s,()=>en.look(r)]))}[n.key.length===1?n.key.toLowerCase():""];!i||n.key===" "&&n.target.closest?.("button")||(n.preventDefault(),i())});function CP(){try{it=W_(Gt("scene"),new URLSearchParams(location.search).get("picture"))}catch(n){return de.trouble="This browser shows no WebGL 2, so there is no picture; numbers and plots work. Hardware acceleration may be off in its settings.",gr(de.trouble),console.warn(String(n.message??n)),null}return it.wants=(n,e)=>fr(ui,{type:"level",mesh:n,value:e}),sh(it),gd(ia,it.options),new ResizeObserver(()=>yl(it)).observe(Gt("stage")),yl(it),RP(),nx($r)}async function RP(){ta=_S({stage:it,player:$r,leave:Hp,moment:PS,changed:()=>pd(ia,ta.mode),take:()=>{de.state?.devices.includes("web:")&&!de.state.device.startsWith("web:")&&en.device("web:")},strength:()=>Math.min(1,LS()/Wp())}),v0(ia,await gS(),n=>vS(ta,n).catch(({message:e})=>{de.refusal={text:`The headset: ${e}`,until:performance.now()/1e3+6}}))}function SS(n,e){let t=Object.assign(document.createElement("a"),{href:URL.createObjectURL(e),download:n});t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}var MS=n=>`thigma-${(de.snapshot?.time??0).toFixed(1)}s.${n}`,Bl=CP();xx(Gt("help"));var PP=()=>`${de.scene?.title??""}, to ${(de.snapshot?.time??0).toFixed(1)} s`,IP=hS(Gt("tabs"),[["plots","Plots"],["parameters","Parameters"],["levels","Levels"],["events","Events"],["build","Scene"]],n=>Ay(na,n==="build"));Mh(Ui);gr("Connecting …");var bS=/^#token=([0-9a-f]+)$/.exec(location.hash)?.[1];ui=ox(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/live${bS?`?token=${bS}`:""}`,{message:n=>wP[n.type??n.kind]?.(n),opened:TP,lost:AP});setInterval(Nh,_P);var zp=performance.now(),wS=0,RS=0,ES=0;function PS(){de.fresh&&(de.shown=de.snapshot,it&&xl(it,de.shown),de.fresh=!1)}function LP(){return ta?.session||it&&!K_(it)||(PS(),!it||!Q_(it))?!1:(RS+=1,aS(MP,it,de.shown),!0)}function IS(n){requestAnimationFrame(IS);let e=LS();Bl&&rx(Bl,(n-zp)/1e3,e,Wp()),Bl&&sx(Bl,(n-zp)/1e3),zp=n,Nh();let t=LP();wS+=1,ty(Ui,de.shown?.time??0);let i=performance.now();wS%6!==0&&!(t&&i>=ES)||(NP(n/1e3,e),ES=10*performance.now()-9*i)}var LS=()=>de.snapshot?Math.hypot(...de.snapshot.force):0;function Wp(){let n=de.snapshot?.metresPerNewton;return n>0&&de.scene?de.scene.object.radius/n:3}function NP(n,e){y0(ia,de),hy(vP,de.shown,de.state,de.scene,de.parameters,Ui.pointed),fy(Gt("row-legend"),de.shown),dy(Gt("legend"),de.shown,de.scene,Hy(AS)),iS(TS,de.state,de.shown),S0(Gt("hint"),b0(xP,de,{now:n,newtons:e,holding:de.holding&&ri.clutch,turned:de.turned,touch:Bl?.touch??matchMedia("(pointer: coarse)").matches},en))}requestAnimationFrame(IS);window.thigma={session:de,hand:ri,plots:Ui,sound:Vp,player:$r,act:en,ask:n=>fr(ui,n),get stage(){return it},get link(){return ui},get xr(){return ta},builder:na,get gizmo(){return Gs},get drawn(){return RS}};})();
